#include "assessment/statistics/step_change.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "assessment/statistics/descriptive.h"

namespace assessment {

base::Result<StepChange> find_step_change(std::span<const double> values) {
  if (values.size() < 4) {
    return base::Error{base::ErrorCode::not_enough_data, "a change of level needs four values"};
  }
  if (!all_usable(values)) {
    return base::Error{base::ErrorCode::invalid_input,
                       "a value is not a number that can be computed with"};
  }
  StepChange best;
  for (std::size_t split = 1; split < values.size(); ++split) {
    const auto before = values.first(split), after = values.subspan(split);
    StepChange change;
    change.last_before = static_cast<int>(split);
    change.mean_before = mean_of(before);
    change.mean_after = mean_of(after);
    change.residual_squares = sum_of_squares_about(change.mean_before, before) +
                              sum_of_squares_about(change.mean_after, after);
    if (split == 1 || change.residual_squares < best.residual_squares) best = change;
  }
  return best;
}

double aicc(double residual_squares, int values, int parameters) {
  assert(residual_squares > 0.0 && values > parameters + 1);
  const double n = values, k = parameters;
  const double aic = n * std::log(2.0 * std::numbers::pi * residual_squares / n) + n + 2.0 * k;
  return aic + 2.0 * k * (k + 1.0) / (n - k - 1.0);
}

}  // namespace assessment
