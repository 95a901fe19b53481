#include "app/server/import_table.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "app/server/csv_reader.h"
#include "app/server/import_values.h"
#include "app/server/people_import.h"
#include "database/text_limits.h"

namespace app {
namespace {

constexpr std::array<const char*, kImportColumns> kNames = {
    "name", "display_name", "email", "role", "level", "cases", "groups", "curriculum"};

constexpr const char* kHeaderLine =
    "name,display_name,email,role,level,cases,groups,curriculum (name and display_name are needed)";

// Spreadsheets leave no-break spaces as well as blanks around cells.
std::string trimmed(const std::string& text) {
  constexpr const char* kNoBreakSpace = "\xc2\xa0";
  std::string_view rest = text;
  for (std::size_t before = 0; before != rest.size();) {
    before = rest.size();
    while (!rest.empty() && std::isspace(static_cast<unsigned char>(rest.front())) != 0)
      rest.remove_prefix(1);
    while (!rest.empty() && std::isspace(static_cast<unsigned char>(rest.back())) != 0)
      rest.remove_suffix(1);
    if (rest.starts_with(kNoBreakSpace)) rest.remove_prefix(2);
    if (rest.ends_with(kNoBreakSpace)) rest.remove_suffix(2);
  }
  return std::string(rest);
}

// "Display name" and "display_name" are one column.
std::string column_name(const std::string& cell) {
  std::string name = trimmed(cell);
  for (char& c : name) {
    c = c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return name;
}

using Order = std::vector<ImportColumn>;  // what each cell of a row is

// The columns by the header, or what is wrong with it.
std::optional<Order> read_header(const CsvRow& header, std::vector<std::string>& problems) {
  Order order;
  for (const std::string& cell : header.cells) {
    const std::string name = column_name(cell);
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) {
      problems.push_back("The column " + quoted_cell(trimmed(cell)) +
                         " is unknown: remove it or rename it; the first line is " + kHeaderLine +
                         ".");
      continue;
    }
    const auto column = static_cast<ImportColumn>(found - kNames.begin());
    if (std::find(order.begin(), order.end(), column) != order.end()) {
      problems.push_back("The column \"" + name + "\" is there twice: remove one of them.");
    }
    order.push_back(column);
  }
  for (const ImportColumn needed : {ImportColumn::name, ImportColumn::display_name}) {
    if (std::find(order.begin(), order.end(), needed) == order.end()) {
      problems.push_back(std::string("The column \"") + kNames[static_cast<std::size_t>(needed)] +
                         "\" is missing: the first line is " + kHeaderLine + ".");
    }
  }
  if (!problems.empty()) return std::nullopt;
  return order;
}

ImportLine read_line(const CsvRow& row, const Order& order) {
  ImportLine line;
  line.line = row.line;
  line.problem = row.problem;
  for (std::size_t i = 0; i < std::min(row.cells.size(), order.size()); ++i) {
    line.cells[static_cast<std::size_t>(order[i])] = trimmed(row.cells[i]);
  }
  if (line.problem.empty() && row.cells.size() != order.size()) {
    line.problem = "the row has " + std::to_string(row.cells.size()) +
                   " cells and the first line " + std::to_string(order.size()) +
                   ": add what is missing, or put a cell that holds the separator in quotes";
  }
  return line;
}

// What makes the text no list at all.
std::optional<std::string> problem_of(const std::string& csv) {
  if (csv.find_first_not_of(" \t\r\n") == std::string::npos) {
    return "The file is empty: its first line names the columns, " + std::string(kHeaderLine) + ".";
  }
  if (csv.size() > kLongestImport) {
    return "The file is too long: at most " + std::to_string(kLongestImport / 1024) +
           " kB; split it into several.";
  }
  // a browser reads what is not UTF-8 as replacement characters
  const bool replaced = csv.find("\xef\xbf\xbd") != std::string::npos;
  if (replaced || !database::check_text("file", csv, kLongestImport)) {
    return "The file is not UTF-8 text: save it as \"CSV UTF-8\" in the spreadsheet.";
  }
  return std::nullopt;
}

}  // namespace

ImportTable read_import_table(const std::string& csv) {
  ImportTable table;
  if (const auto problem = problem_of(csv)) {
    table.problems.push_back(*problem);
    return table;
  }
  const CsvText text = read_csv(csv);
  if (text.unclosed_line > 0) {
    table.problems.push_back("The quote opened in line " + std::to_string(text.unclosed_line) +
                             " is never closed: close it, or double it to keep it as text.");
    return table;
  }
  if (text.rows.empty()) {
    table.problems.push_back("The file holds no line with text.");
    return table;
  }
  const auto order = read_header(text.rows.front(), table.problems);
  if (!order) return table;
  if (text.rows.size() - 1 > kMostImportRows) {
    table.problems.push_back("The file has " + std::to_string(text.rows.size() - 1) +
                             " rows: at most " + std::to_string(kMostImportRows) +
                             " are taken at once; split it into several.");
    return table;
  }
  if (text.rows.size() == 1) {
    table.problems.push_back("The file names its columns and no people: add a row for each.");
    return table;
  }
  for (std::size_t i = 1; i < text.rows.size(); ++i) {
    table.lines.push_back(read_line(text.rows[i], *order));
  }
  return table;
}

}  // namespace app
