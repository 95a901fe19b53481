// Reads `sources:` of a catalogue file: where its numbers come from.
#pragma once

#include <string>
#include <vector>

#include "curricula/fields.h"

namespace curricula {

// One sentence of all topics, each of which must be there: "stiffness: ...; friction: ...".
std::string read_sources(const YamlNode& node, const std::vector<std::string>& topics,
                         Problems& problems);

}  // namespace curricula
