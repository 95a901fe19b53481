// Two texts, line by line: what was taken out and what was put in.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace curricula {

struct DiffLine {
  enum class Kind { same, removed, added };
  Kind kind = Kind::same;
  std::string text;                     // without the line's end
  int before_line = 0, after_line = 0;  // 1-based; 0 where it does not exist
};

// A shortest list of removed and added lines that turns one text into the other. Regions of more
// than some thousand changed lines are given as one block removed and one added.
std::vector<DiffLine> line_diff(std::string_view before, std::string_view after);

}  // namespace curricula
