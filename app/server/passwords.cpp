#include "app/server/passwords.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string_view>

#include <sodium.h>

#include "app/server/common_passwords.h"

namespace app {
namespace {

// OWASP ASVS 5.0: Argon2id with at least 19 MiB and two passes
constexpr unsigned long long kPasses = 2;
constexpr std::size_t kMemoryBytes = std::size_t{19} * 1024 * 1024;
constexpr std::size_t kShortest = 8, kLongest = 128;  // characters

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// Characters of a UTF-8 text: every byte that does not continue one.
std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

bool one_character_repeated(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [&](char c) { return c == text.front(); });
}

base::Error refuse(const char* sentence) {
  return base::Error{base::ErrorCode::invalid_input, sentence};
}

}  // namespace

base::Status check_new_password(const std::string& password, const std::string& name) {
  const std::size_t count = characters(password);
  if (count < kShortest) return refuse("Choose a password of at least 8 characters.");
  if (count > kLongest) return refuse("Choose a password of at most 128 characters.");
  const std::string plain = lower(password);
  if (is_common_password(plain) || one_character_repeated(plain)) {
    return refuse("This password is on the list of common ones; choose another.");
  }
  if (plain == lower(name)) return refuse("The password must not be the name; choose another.");
  return base::Done{};
}

base::Result<std::string> hash_password(const std::string& password) {
  std::array<char, crypto_pwhash_STRBYTES> phc{};
  if (sodium_init() < 0 ||
      crypto_pwhash_str_alg(phc.data(), password.data(), password.size(), kPasses, kMemoryBytes,
                            crypto_pwhash_ALG_ARGON2ID13) != 0) {
    return base::Error{base::ErrorCode::unavailable,
                       "There is not enough memory to hash a password; try again."};
  }
  return std::string(phc.data());
}

bool verify_password(const std::string& phc, const std::string& password) {
  // longer ones were never accepted, and hashing them is a way to keep the server busy
  if (sodium_init() < 0 || phc.empty() || characters(password) > kLongest) return false;
  return crypto_pwhash_str_verify(phc.c_str(), password.data(), password.size()) == 0;
}

void spend_password_time(const std::string& password) {
  if (characters(password) > kLongest) return;
  [[maybe_unused]] const auto unused = hash_password(password);
}

bool needs_rehash(const std::string& phc) {
  return crypto_pwhash_str_needs_rehash(phc.c_str(), kPasses, kMemoryBytes) != 0;
}

}  // namespace app
