// The text of one part of a YAML file, cut out so that it stands alone.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "curricula/yaml_tree.h"

namespace curricula {

// The text of a node that is a map, cut out of `text` so that it stands alone: its own indentation
// removed, up to the last line with content before `next`, the byte where the following node
// begins (text.size() when there is none).
std::string source_of(std::string_view text, const YamlNode& map, std::size_t next);

}  // namespace curricula
