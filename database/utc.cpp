#include "database/utc.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>

#include "database/store.h"

namespace database {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Whether `text` has the shape of `pattern`, where 0 stands for any digit.
bool has_shape(const std::string& text, const std::string& pattern) {
  if (text.size() < pattern.size()) return false;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '0' ? !is_digit(text[i]) : text[i] != pattern[i]) return false;
  }
  return true;
}

bool is_date(const std::string& text) {
  using std::chrono::day, std::chrono::month, std::chrono::year;
  const auto number = [&](std::size_t from, std::size_t length) {
    return std::stoi(text.substr(from, length));
  };
  const std::chrono::year_month_day date{year(number(0, 4)),
                                         month(static_cast<unsigned>(number(5, 2))),
                                         day(static_cast<unsigned>(number(8, 2)))};
  return date.ok() && number(11, 2) < 24 && number(14, 2) < 60 && number(17, 2) < 60;
}

}  // namespace

std::string utc_now() {
  using namespace std::chrono;
  const auto now = floor<milliseconds>(system_clock::now());
  const std::time_t whole_seconds = system_clock::to_time_t(floor<seconds>(now));
  std::tm fields{};
  gmtime_r(&whole_seconds, &fields);
  std::array<char, 32> date{};
  std::strftime(date.data(), date.size(), "%Y-%m-%dT%H:%M:%S", &fields);
  std::array<char, 8> fraction{};
  std::snprintf(fraction.data(), fraction.size(), ".%03dZ",
                static_cast<int>((now - floor<seconds>(now)).count()));
  return std::string(date.data()) + fraction.data();
}

base::Result<std::string> stored_utc(const std::string& text) {
  if (text.empty()) return utc_now();
  const base::Error error{base::ErrorCode::invalid_input,
                          "A time is written in UTC like 2026-01-31T12:00:00Z."};
  const std::string shape = "0000-00-00T00:00:00";
  if (!has_shape(text, shape) || text.back() != 'Z' || !is_date(text)) return error;
  std::string fraction = text.substr(shape.size(), text.size() - shape.size() - 1);
  if (!fraction.empty()) {
    if (fraction[0] != '.' || fraction.size() < 2 || fraction.size() > 10) return error;
    for (std::size_t i = 1; i < fraction.size(); ++i) {
      if (!is_digit(fraction[i])) return error;
    }
    fraction.erase(0, 1);
  }
  fraction.resize(3, '0');
  return text.substr(0, shape.size()) + "." + fraction + "Z";
}

}  // namespace database
