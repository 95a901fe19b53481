#include "reports/csv.h"

#include <cstdlib>

namespace reports {
namespace {

bool is_number(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return !text.empty() && end == text.c_str() + text.size();
}

std::string guarded(const std::string& text) {
  constexpr const char* kFormulaStarts = "=+-@\t\r";
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
