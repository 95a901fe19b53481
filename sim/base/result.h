// A value, or the reason there is none. For failures a correct program must expect: a missing
// file, a corrupt recording, too few trials. The interface is the part of std::expected (C++23)
// that we use, so it can be replaced by it later.
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace base {

enum class ErrorCode {
  invalid_input,
  not_found,
  corrupt_data,
  not_enough_data,
  conflict,
  denied,
  unavailable
};

struct Error {
  ErrorCode code;
  std::string message;  // one sentence for the person who can act on it
};

template <typename T>
class [[nodiscard]] Result {
 public:
  // Implicit on purpose, so that a function can `return value;` or `return Error{...};`.
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}

  bool has_value() const { return std::holds_alternative<T>(state_); }
  explicit operator bool() const { return has_value(); }

  const T& operator*() const& { return get<T>(); }
  T operator*() && { return std::move(const_cast<T&>(get<T>())); }  // moves the value out
  const T* operator->() const { return &get<T>(); }
  const Error& error() const { return get<Error>(); }

 private:
  // Asking for the wrong alternative is a bug in the caller, not a failure to handle.
  template <typename U>
  const U& get() const {
    const U* alternative = std::get_if<U>(&state_);
    assert(alternative && "check has_value() first");
    return *alternative;
  }

  std::variant<T, Error> state_;
};

// What a function returns that has nothing to say but that it worked.
struct Done {};
using Status = Result<Done>;

}  // namespace base
