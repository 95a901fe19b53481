// Submovements: the peaks of the speed. A peak is a value (or a flat top) higher than both its
// neighbours, with
//
//     height >= 0.10 v_max,   prominence >= 0.05 v_max,   distance >= 0.1 s
//
// Of two peaks closer than the distance, the higher one stays. Prominence is the drop one has to
// go down, on the side where it is smaller, before the ground rises above the peak again: the
// semantics of scipy.signal.find_peaks.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace assessment {

struct PeakLimits {
  double height = 0.0;       // in the unit of the values
  double prominence = 0.0;   // likewise
  std::size_t distance = 1;  // samples
};

// Positions of the peaks, ascending; of a flat top the middle one, rounded down.
std::vector<std::size_t> find_peaks(std::span<const double> values, const PeakLimits& limits);

// `speed` at `rate` Hz, already low-passed. 0 when nothing moves.
int count_submovements(std::span<const double> speed, double rate);

}  // namespace assessment
