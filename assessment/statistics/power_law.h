// The power law of practice: over trials n = 1, 2, 3, ...
//
//     T(n) = a n^-b        learning rate = 2^-b: what is left of T each time n doubles
//
// (Newell and Rosenbloom, in Anderson (ed.), Cognitive Skills, 1981.) A description of what was
// recorded, not a forecast.
#pragma once

#include <optional>
#include <span>

#include "assessment/statistics/effect_size.h"
#include "sim/base/result.h"

namespace assessment {

enum class PowerLawScale {
  raw,     // least squares of T: what nls(y ~ a * n^-b) gives
  log_log  // least squares of ln T over ln n: what lm(log(y) ~ log(n)) gives
};

struct PowerLaw {
  PowerLawScale scale = PowerLawScale::raw;
  double a = 0.0;              // T at the first trial, in the unit of the values
  double b = 0.0;              // positive: T falls with practice
  double learning_rate = 1.0;  // 2^-b
  // Of the fitted scale (T or ln T); absent when the values do not vary.
  std::optional<double> r_squared;
  double residual_deviation = 0.0;  // sqrt(RSS / (n - 2)), of the fitted scale
  // raw: where the profile RSS(b) reaches RSS_min (1 + F(1, n-2) / (n-2)); log_log: b -+ t SE.
  // Absent when a limit lies outside the searched range.
  std::optional<Interval> b_interval;
  bool at_bound = false;        // b sits at the end of the searched range (+-kLargestExponent)
  bool not_identified = false;  // the values say nothing about b: all of them are zero
  int count = 0;

  double value_at(double trial) const;
};

inline constexpr double kLargestExponent = 5.0;

// `trials` are the ordinals (1, 2, 3, ..., gaps allowed), `values` the value of each.
// Fails with not_enough_data for fewer than three values or fewer than two different ordinals;
// invalid_input for unequal lengths, an ordinal below 1, a value that is not finite and, on the
// log-log scale, one that is not positive.
base::Result<PowerLaw> fit_power_law(std::span<const double> trials, std::span<const double> values,
                                     PowerLawScale scale = PowerLawScale::raw,
                                     double confidence = 0.95);

}  // namespace assessment
