#include "reports/number.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace reports {

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value));
  const std::string digits = text;
  const bool zero = digits.find_first_not_of("0.") == std::string::npos;
  return (value < 0.0 && !zero ? "\u2212" : "") + digits;
}

std::string plain(double value) {
  const double size = std::abs(value);
  if (size >= 100.0 || size == 0.0) return fixed(value, size >= 1000.0 || size == 0.0 ? 0 : 1);
  if (size >= 10.0) return fixed(value, 1);
  if (size >= 0.1) return fixed(value, 2);
  return fixed(value, 3);
}

std::string exact(double value) {
  char text[64];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  return error == std::errc{} ? std::string(text, end) : std::string();
}

std::string p_text(double p) {
  if (p < 0.0001) return "< 0.0001";
  char text[32];
  if (p >= 0.1) {
    std::snprintf(text, sizeof text, "%.2f", p);
  } else {
    std::snprintf(text, sizeof text, "%.2g", p);
  }
  return text;
}

}  // namespace reports
