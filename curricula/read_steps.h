// Reads `steps:` of an exercise.
#pragma once

#include <vector>

#include "curricula/fields.h"

namespace curricula {

// What the scene allows a step to ask for.
struct Reach {
  bool known = false;   // false: the scene is broken, so that nothing can be said
  double start = 0.0;   // mm inserted when the trial begins
  double length = 0.0;  // mm, the shorter of vessel and instrument
  std::string shorter;  // which of the two, for the sentence
};

std::vector<Step> read_steps(const std::vector<const YamlNode*>& nodes, const Reach& reach,
                             Problems& problems);

}  // namespace curricula
