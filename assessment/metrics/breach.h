// Limits are watched at every step of the simulation, a thousand times a second, the recording
// holds a hundred samples a second. So that no report says "limit of 2 N exceeded, peak force 1.98
// N", a peak also takes in the values that the recording notes where a limit was broken.
#pragma once

#include <string_view>

#include "assessment/trial.h"

namespace assessment {

// The largest finite value noted at a breach of a limit on `metric`; 0 when there was none.
double value_at_breach(const RecordedTrial& trial, std::string_view metric);

}  // namespace assessment
