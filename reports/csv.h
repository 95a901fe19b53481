// Comma-separated values as spreadsheets and scripts expect them: UTF-8, dot decimals, quoted
// where needed. A text that a spreadsheet would take for a formula gets an apostrophe in front.
#pragma once

#include <string>
#include <vector>

namespace reports {

std::string csv_row(const std::vector<std::string>& cells);

}  // namespace reports
