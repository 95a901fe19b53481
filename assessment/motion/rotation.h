// Turning to and fro.
#pragma once

#include <span>

namespace assessment {

// Sum of |a_i - a_{i-1}| of an unwrapped angle (or any other quantity), in its unit.
double total_variation(std::span<const double> values);

// How often the direction of movement changes by more than `dead_band` (in the unit of the values):
// a change counts once the value has come back from its last extreme by more than the dead band.
int count_reversals(std::span<const double> values, double dead_band);

}  // namespace assessment
