// Describing one series of numbers. Nothing here assumes a unit: results are in the unit of the
// values unless a name says otherwise.
#pragma once

#include <optional>
#include <span>

#include "sim/base/result.h"

namespace assessment {

struct Summary {
  int count = 0;
  double mean = 0.0;
  std::optional<double> standard_deviation;  // with n - 1; absent for a single value
  double minimum = 0.0;
  double quartile_low = 0.0;  // 25 %, type 7
  double median = 0.0;
  double quartile_high = 0.0;  // 75 %, type 7
  double maximum = 0.0;
};

// Fails with not_enough_data for no value, invalid_input for one that is not finite.
base::Result<Summary> summarise(std::span<const double> values);

// The pieces alone. The mean and the median need at least one value.
double mean_of(std::span<const double> values);
double median_of(std::span<const double> values);
double sum_of_squares_about(double centre, std::span<const double> values);

// Finite, and below 1e150 in size so that squares fit. Every statistic refuses other values.
bool all_usable(std::span<const double> values);

// Quantile for a probability in [0, 1] by linear interpolation of the order statistics at
// 1 + (n - 1) p: type 7 of Hyndman and Fan, The American Statistician 50 (1996) 361, the default
// of R and numpy. `values` must not be empty and need not be sorted.
double quantile(std::span<const double> values, double probability);

}  // namespace assessment
