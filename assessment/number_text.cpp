#include "assessment/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <system_error>

namespace assessment {
namespace {

constexpr int kMostDecimals = 15;

int usual_decimals(std::string_view unit) {
  const bool coarse =
      unit == "s" || unit == "mm" || unit == "deg" || unit == "mm/s" || unit == "N mm";
  return coarse ? 1 : 2;
}

std::string fixed(double value, int decimals) {
  std::array<char, 400> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, decimals);
  if (end.ec != std::errc()) return exact_text(value);
  std::string written(text.data(), end.ptr);
  if (written.find('.') != std::string::npos) {
    written.erase(written.find_last_not_of('0') + 1);
    if (written.back() == '.') written.pop_back();
  }
  return written == "-0" ? "0" : written;
}

double read(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

int side(double value, double bound) { return (value > bound) - (value < bound); }

int decimals_in(const std::string& text) {
  const auto point = text.find('.');
  return point == std::string::npos ? 0 : static_cast<int>(text.size() - point) - 1;
}

}  // namespace

std::string exact_text(double value) {
  std::array<char, 64> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return std::string(text.data(), end.ptr);
}

std::string rounded_text(double value, std::string_view unit) {
  return fixed(value, usual_decimals(unit));
}

std::string text_beside(double value, double bound, std::string_view unit) {
  for (int decimals = usual_decimals(unit); decimals <= kMostDecimals; ++decimals) {
    std::string text = fixed(value, decimals);
    if (side(read(text), bound) == side(value, bound)) return text;
  }
  return exact_text(value);
}

std::string distance_text(double value, double bound, std::string_view unit) {
  const std::string shown = text_beside(value, bound, unit);
  const int decimals =
      std::min(kMostDecimals, std::max(decimals_in(shown), decimals_in(exact_text(bound))));
  const std::string text = fixed(std::abs(read(shown) - bound), decimals);
  const bool vanished = read(text) == 0.0 && value != bound;
  return vanished ? exact_text(std::abs(value - bound)) : text;
}

}  // namespace assessment
