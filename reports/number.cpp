#include "reports/number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace reports {
namespace {

std::string superscript(int number) {
  static const char* const kDigits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                        "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = number < 0 ? "\u207b" : "";
  for (const char digit : std::to_string(std::abs(number))) text += kDigits[digit - '0'];
  return text;
}

std::string printed(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value));
  const std::string digits = text;
  const bool zero = digits.find_first_not_of("0.") == std::string::npos;
  return (value < 0.0 && !zero ? "\u2212" : "") + digits;
}

int plain_decimals(double value) {
  const double size = std::abs(value);
  if (size >= 999.95 || size == 0.0) return 0;
  if (size >= 9.995) return 1;
  return size >= 0.0995 ? 2 : 3;
}

std::string plain(double value) { return fixed(value, plain_decimals(value)); }

int common_decimals(const std::vector<double>& values, int most) {
  int decimals = 0;
  double power = 1.0;
  const auto shown = [&](double value) {
    const double scaled = value * power;
    return std::abs(scaled - std::round(scaled)) <= 1e-9 * std::max(1.0, std::abs(scaled));
  };
  while (decimals < most && !std::all_of(values.begin(), values.end(), shown)) {
    ++decimals;
    power *= 10.0;
  }
  return decimals;
}

std::string exact(double value) {
  char text[64];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  return error == std::errc{} ? std::string(text, end) : std::string();
}

std::string p_text(double p) {
  if (p < 0.0001) return "< 0.0001";
  if (p >= 0.0995) return printed("%.2f", p);
  const std::string text = printed("%.2g", p);
  return text == "0.05" && p != 0.05 ? printed("%.4f", p) : text;
}

std::string p_statement(double p) {
  const std::string text = p_text(p);
  return text[0] == '<' ? "p " + text : "p = " + text;
}

std::string small_text(double value) {
  if (!(value > 0.0) || value >= 0.0001) return p_text(value);
  int exponent = static_cast<int>(std::floor(std::log10(value)));
  std::string digits = printed("%.1f", value / std::pow(10.0, exponent));
  if (digits == "10.0") {
    digits = "1.0";
    ++exponent;
  }
  return digits + " \u00d7 10" + superscript(exponent);
}

std::string power_of_ten_text(int exponent) {
  return exponent < -3 ? "10" + superscript(exponent)
                       : fixed(std::pow(10.0, exponent), std::max(0, -exponent));
}

}  // namespace reports
