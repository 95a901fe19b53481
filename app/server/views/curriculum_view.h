// A curriculum as its editor sees it: text, problems at their lines, and the exercises it holds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "curricula/catalogue.h"
#include "curricula/check.h"
#include "curricula/diff.h"
#include "curricula/line_diff.h"

namespace app {

// What is wrong with a text, seen alone and beside the version that is published now.
struct CheckedText {
  std::optional<curricula::Curriculum> curriculum;  // when the text alone has no error
  std::vector<curricula::Problem> problems;         // by line
  int errors() const;
  int warnings() const;
};

// `published`: the text of the newest published version of the same curriculum, or null.
CheckedText check_text(const std::string& yaml, const std::string* published,
                       const curricula::Catalogue& catalogue);

nlohmann::json check_json(const CheckedText& checked, const std::string& yaml,
                          const curricula::Library& library);

nlohmann::json changes_json(const std::vector<curricula::Change>& changes);
// The lines of a difference; unchanged ones far from a change are left out.
nlohmann::json diff_lines_json(const std::vector<curricula::DiffLine>& lines);

}  // namespace app
