// The cells of one line of a list of people as values, or what is wrong with them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/server/import_table.h"
#include "database/people.h"
#include "sim/base/result.h"

namespace app {

// Absent where the cell is empty or unreadable.
struct ImportValues {
  std::optional<database::Role> role;
  std::optional<database::Level> level;
  std::optional<int> cases;
  std::optional<std::vector<std::string>> groups;
  std::optional<std::string> curriculum;
};

// Each problem is a part of a sentence that says what to do. `curricula`: those published.
ImportValues read_import_values(const ImportLine& line, const std::vector<std::string>& curricula,
                                std::vector<std::string>& problems);

// Adds a refusal of the store, as a part of a sentence.
void add_import_failure(const base::Status& status, std::vector<std::string>& problems);
// As the database compares names: A to Z only.
std::string lower_name(std::string text);
std::string quoted_cell(const std::string& text);  // cut when it is long

}  // namespace app
