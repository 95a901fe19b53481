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

#include "curricula/problems.h"

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

struct YamlTree {
  YamlNode root;
  bool truncated = false;  // a syntax error: what follows it was not seen
};

YamlTree parse_yaml(std::string_view text, Problems& problems);

}  // namespace curricula
