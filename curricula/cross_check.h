// The checks that need the whole curriculum: names that refer to each other, and cycles.
#pragma once

#include <vector>

#include "curricula/read_exercise.h"
#include "curricula/read_plan.h"

namespace curricula {

struct Drafts {
  std::vector<ExerciseDraft> exercises;
  std::vector<BlockDraft> blocks;
  std::vector<Fields::Word> retention;  // exercises named by the retention test
  bool truncated = false;  // a syntax error hides the rest: what is unknown may be there
};

void cross_check(const Drafts& drafts, Problems& problems);

}  // namespace curricula
