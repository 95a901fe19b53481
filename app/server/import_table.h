// The cells of a list of people, found by the names of its columns.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace app {

enum class ImportColumn { name, display_name, email, role, level, cases, groups, curriculum };
inline constexpr std::size_t kImportColumns = 8;

struct ImportLine {
  int line = 0;
  std::array<std::string, kImportColumns> cells;  // without blanks around; empty where absent
  std::string problem;                            // of its shape; the cells may be wrong then

  const std::string& cell(ImportColumn column) const {
    return cells[static_cast<std::size_t>(column)];
  }
};

struct ImportTable {
  std::vector<ImportLine> lines;
  std::vector<std::string> problems;  // of the file as a whole; then there are no lines
};

ImportTable read_import_table(const std::string& csv);

}  // namespace app
