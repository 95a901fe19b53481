// A YAML file as a tree that remembers where everything stands: the safe subset only.
//
//   bytes -> characters checked -> yaml-cpp's events -> YamlNode tree + problems
//
// The subset has maps with plain words as keys, lists and scalars. Anchors, aliases, tags, several
// documents, duplicate keys and depths over 32 are problems. Nothing here knows what a curriculum
// is. Never throws.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "curricula/check.h"

namespace curricula {

inline constexpr std::size_t kFileSizeLimit = 1024 * 1024;  // bytes
inline constexpr std::size_t kDepthLimit = 32;

struct YamlEntry;

struct YamlNode {
  // unusable: refused already (an alias, say), so that nobody complains about it again
  enum class Kind { null, scalar, list, map, unusable };
  Kind kind = Kind::null;
  int line = 1, column = 1;        // 1-based, columns in characters
  std::size_t begin = 0;           // byte of the first character in the file
  std::string text;                // scalar: its value
  bool quoted = false;             // scalar: "350" is a word, 350 a number
  bool flow = false;               // map, list: written with brackets
  bool complete = true;            // false: a syntax error cut it short
  std::vector<YamlNode> items;     // list
  std::vector<YamlEntry> entries;  // map, in the order written

  const YamlNode* find(std::string_view key) const;  // null when absent or no map
};

struct YamlEntry {
  YamlNode key, value;
};

// Collects problems; a broken megabyte must not make a million sentences.
class Problems {
 public:
  void error(int line, int column, std::string message);
  void error(const YamlNode& at, std::string message) {
    error(at.line, at.column, std::move(message));
  }
  void warning(const YamlNode& at, std::string message);
  bool any_error() const { return any_error_; }
  std::size_t count() const { return list_.size() + dropped_; }
  std::vector<Problem> sorted() &&;  // in the order of their lines

 private:
  void add(Problem problem);
  std::vector<Problem> list_;
  bool any_error_ = false;
  std::size_t dropped_ = 0;
};

struct YamlTree {
  YamlNode root;
  bool truncated = false;  // a syntax error: what follows it was not seen
};

YamlTree parse_yaml(std::string_view text, Problems& problems);

// The text of a node that is a map, cut out of `text` so that it stands alone: its own indentation
// removed, up to the last line with content before `next`, the byte where the following node
// begins (text.size() when there is none).
std::string source_of(std::string_view text, const YamlNode& map, std::size_t next);

}  // namespace curricula
