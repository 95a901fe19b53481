// How large a difference between two groups is, free of the unit.
#pragma once

#include <optional>
#include <span>

#include "sim/base/result.h"

namespace assessment {

struct Interval {
  double low = 0.0;
  double high = 0.0;
  double confidence = 0.95;
};

// Hedges' g, first minus second:
//
//     d = (m1 - m2) / s_pooled,   g = J d,
//     J = Gamma(df / 2) / (sqrt(df / 2) Gamma((df - 1) / 2)),   df = n1 + n2 - 2
//
// (Hedges, J. Educational Statistics 6 (1981) 107). The interval is J sqrt(1/n1 + 1/n2) times the
// non-centralities at which the observed t is the upper and the lower quantile of non-central t.
struct HedgesG {
  double g = 0.0;
  double cohen_d = 0.0;
  double correction = 1.0;           // J
  double pooled_deviation = 0.0;     // in the unit of the values
  std::optional<Interval> interval;  // absent where non-central t cannot be evaluated (|t| > 1000)
};

// Fails with not_enough_data when a group is empty, for fewer than four values in all (with df = 1
// the correction J is zero) and when nobody differs within the groups, because g then has no
// denominator; invalid_input for a value that is not finite.
base::Result<HedgesG> hedges_g(std::span<const double> first, std::span<const double> second,
                               double confidence = 0.95);

// From all pairs of a value of the first with a value of the second group.
struct Dominance {
  double cliffs_delta = 0.0;  // P(first > second) - P(first < second), -1..1
  double first_lower = 0.5;   // P(first < second) + P(equal) / 2: the area under the ROC curve
  bool complete_separation = false;  // every value of one group lies beyond every one of the other
};

base::Result<Dominance> dominance(std::span<const double> first, std::span<const double> second);

}  // namespace assessment
