// What has to be said beside the numbers of a comparison so that nobody reads too much into them.
#pragma once

#include "assessment/comparison.h"

namespace assessment {

// Fills in `nesting` and `separation` and appends to `warnings`, from the numbers computed so far.
void add_sentences(GroupComparison& comparison);

}  // namespace assessment
