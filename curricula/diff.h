// What changed between two versions of a curriculum, and whether the version number says so.
//
// Scores are comparable within a major version: a changed step, limit, scene or threshold is major,
// a change of the plan or of what is recorded minor, a change of words a patch.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "curricula/check.h"
#include "curricula/curriculum.h"

namespace curricula {

struct Change {
  enum class Weight { patch, minor, major };
  Weight weight = Weight::patch;
  std::string exercise_id;  // empty: of the curriculum itself
  std::string sentence;     // "linear: step 'feed-1' goes to 340 mm instead of 350 mm"
};
const char* word(Change::Weight weight);  // "patch", "minor", "major"

// In the order of the newer file; empty when both say the same, comments aside.
std::vector<Change> diff(const Curriculum& before, const Curriculum& after);

// What speaks against publishing `after` when `before` is published: the same version with other
// content, a version bump too small for the change, an exercise whose scoring changed under the
// same version. Lines are those of `after`. No problems when `before` is a draft.
std::vector<Problem> compare_versions(const Curriculum& before, const Curriculum& after);

}  // namespace curricula
