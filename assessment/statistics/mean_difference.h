// The difference of two means, first minus second, without assuming equal variances:
//
//     t = (m1 - m2) / sqrt(s1^2 / n1 + s2^2 / n2)
//
// with the degrees of freedom of Welch and Satterthwaite (Welch, Biometrika 34 (1947) 28).
#pragma once

#include <span>

#include "assessment/statistics/effect_size.h"
#include "sim/base/result.h"

namespace assessment {

struct MeanDifference {
  double difference = 0.0;  // in the unit of the values
  Interval interval;        // likewise
  double t = 0.0;
  double degrees_of_freedom = 0.0;
  double p_two_sided = 1.0;
};

// Fails with not_enough_data for fewer than two values in a group or when neither group varies;
// invalid_input for a value that is not finite.
base::Result<MeanDifference> welch(std::span<const double> first, std::span<const double> second,
                                   double confidence = 0.95);

}  // namespace assessment
