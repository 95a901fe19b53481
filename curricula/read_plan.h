// Reads `plan:` and `completion:` of a curriculum.
#pragma once

#include <string>
#include <vector>

#include "curricula/fields.h"

namespace curricula {

// A block and where its parts stand, for the checks across blocks.
struct BlockDraft {
  Block block;
  const YamlNode* node = nullptr;
  const YamlNode* id_node = nullptr;     // null when there is no id
  const YamlNode* after_node = nullptr;  // null when it comes after none
  std::vector<Fields::Word> exercises;
};

BlockDraft read_block(const YamlNode& node, Problems& problems);

// The exercises that the retention test names.
std::vector<Fields::Word> read_completion(const YamlNode& node, Problems& problems);

}  // namespace curricula
