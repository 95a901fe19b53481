// Reads comma-separated values as spreadsheets write them: RFC 4180, with semicolons or tabs in
// place of the commas as well, a byte order mark, any line ends, blank lines. Takes every text;
// what is wrong is said with its line. (Debian's libcsv tells neither the line of a row nor what is
// wrong with it, and drops blanks around cells that are not quoted.)
//
// Cells are kept as they stand. A cell that a spreadsheet would take for a formula is text here.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace app {

struct CsvRow {
  int line = 0;  // 1-based; where the row begins
  std::vector<std::string> cells;
  std::string problem;  // of its quotes; empty when there is none
};

struct CsvText {
  char separator = ',';      // the one of , ; and tab that the first row holds most often
  std::vector<CsvRow> rows;  // without blank ones
  int unclosed_line = 0;     // where a quote was opened that nothing closes; 0: none
};

CsvText read_csv(std::string_view text);

}  // namespace app
