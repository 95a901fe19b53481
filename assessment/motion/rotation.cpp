#include "assessment/motion/rotation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace assessment {

double total_variation(std::span<const double> values) {
  double total = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) total += std::abs(values[i] - values[i - 1]);
  return total;
}

int count_reversals(std::span<const double> values, double dead_band) {
  if (values.empty()) return 0;
  int reversals = 0;
  int direction = 0;  // of the movement so far, 0 while within the dead band of the start
  double low = values[0], high = values[0];
  for (const double value : values) {
    low = std::min(low, value);
    high = std::max(high, value);
    if (direction <= 0 && value - low > dead_band) {
      if (direction < 0) ++reversals;
      direction = 1;
      high = value;
    } else if (direction >= 0 && high - value > dead_band) {
      if (direction > 0) ++reversals;
      direction = -1;
      low = value;
    }
  }
  return reversals;
}

}  // namespace assessment
