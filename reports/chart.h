// One drawing with its words and its numbers: the same on screen and in print.
//
// The SVG stands alone: fonts and colours are presentation attributes, every mark also carries a
// class (series-expert, series-novice, series-you, target, limit, axis, grid), so that a page may
// recolour it by its style sheet. It has a <title> and a <desc>, no script, no style attribute and
// no reference to anything outside. Series differ by marker and dash, not by colour alone.
#pragma once

#include <string>
#include <vector>

namespace reports {

struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

struct Chart {
  std::string id;  // unique on its page
  std::string title;
  std::string summary;  // what it shows, in a sentence
  std::string svg;
  Table table;  // the numbers behind it
};

}  // namespace reports
