#include "reports/csv.h"

#include <charconv>

namespace reports {
namespace {

// Plain decimal numbers only: no leading blank or plus, and nothing hexadecimal.
bool is_number(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  return !text.empty() && read.ec == std::errc{} && read.ptr == end;
}

std::string guarded(const std::string& text) {
  constexpr const char* kFormulaStarts = "=+-@\t\r\n";
  const bool risky =
      !text.empty() && std::string(kFormulaStarts).find(text[0]) != std::string::npos;
  return risky && !is_number(text) ? "'" + text : text;
}

}  // namespace

std::string csv_row(const std::vector<std::string>& cells) {
  std::string row;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) row += ',';
    const std::string cell = guarded(cells[i]);
    if (cell.find_first_of(",\"\r\n") == std::string::npos) {
      row += cell;
      continue;
    }
    row += '"';
    for (const char c : cell) {
      if (c == '"') row += '"';
      row += c;
    }
    row += '"';
  }
  return row + "\r\n";
}

}  // namespace reports
