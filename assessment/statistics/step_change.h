// A sudden change of level: the split of a series in two that leaves the smallest squares about
// the two means. Insight, a new grip or a changed apparatus look like this; a smooth curve fitted
// to such a series describes nothing that happened.
#pragma once

#include <span>

#include "sim/base/result.h"

namespace assessment {

struct StepChange {
  int last_before = 0;       // values[0 .. last_before - 1] come before the change
  double mean_before = 0.0;  // in the unit of the values
  double mean_after = 0.0;
  double residual_squares = 0.0;
};

// The earliest of equally good splits. Fails with not_enough_data for fewer than four values,
// invalid_input for one that is not usable.
base::Result<StepChange> find_step_change(std::span<const double> values);

// Akaike's information criterion of a least-squares fit, corrected for few values:
//
//     AIC = n ln(2 pi RSS / n) + n + 2 K,   AICc = AIC + 2 K (K + 1) / (n - K - 1)
//
// (Hurvich and Tsai, Biometrika 76 (1989) 297). `parameters` K counts the residual deviation:
// 3 for a power law, 4 for a step change. Requires n > K + 1 and RSS > 0.
double aicc(double residual_squares, int values, int parameters);

}  // namespace assessment
