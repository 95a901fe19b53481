#include "curricula/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace curricula {

std::string number_text(double value) {
  if (value == 0.0) return "0";  // never "-0"
  std::array<char, 64> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                          std::chars_format::general, 6);
  if (error != std::errc{}) return "?";
  return {buffer.data(), end};
}

}  // namespace curricula
