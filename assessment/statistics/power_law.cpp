#include "assessment/statistics/power_law.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

#include "assessment/statistics/descriptive.h"

namespace assessment {
namespace {

// For a fixed exponent the model is linear in a, so a has a closed form and one search over b is
// left (variable projection): no start values, no local minimum missed by a bad one.
class Profile {
 public:
  // `values` scaled to at most 1 in size, not all zero.
  Profile(std::span<const double> trials, std::span<const double> values) : values_(values) {
    for (const double trial : trials) logs_.push_back(std::log(trial));
  }

  double a(double b) const {
    double xy = 0.0, xx = 0.0;
    for (std::size_t i = 0; i < logs_.size(); ++i) {
      const double x = std::exp(-b * logs_[i]);
      xy += x * values_[i];
      xx += x * x;
    }
    return xy / xx;
  }

  double residual_squares(double b) const {
    const double factor = a(b);
    double sum = 0.0;
    for (std::size_t i = 0; i < logs_.size(); ++i) {
      const double residual = values_[i] - factor * std::exp(-b * logs_[i]);
      sum += residual * residual;
    }
    return sum;
  }

  // Half the derivative of residual_squares; a(b) is stationary, so only b itself counts.
  double half_slope(double b) const {
    const double factor = a(b);
    double sum = 0.0;
    for (std::size_t i = 0; i < logs_.size(); ++i) {
      const double x = std::exp(-b * logs_[i]);
      sum += (values_[i] - factor * x) * factor * x * logs_[i];
    }
    return sum;
  }

 private:
  std::span<const double> values_;
  std::vector<double> logs_;
};

constexpr double kGridStep = 0.05;

template <typename Function>
double root_between(const Function& function, double low, double high) {
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      function, low, high, boost::math::tools::eps_tolerance<double>(50), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

double best_exponent(const Profile& profile) {
  // a coarse scan finds the valley, the root of the slope its floor
  double best = -kLargestExponent;
  double smallest = profile.residual_squares(best);
  const int steps = static_cast<int>(std::lround(2.0 * kLargestExponent / kGridStep));
  for (int k = 1; k <= steps; ++k) {
    const double b = -kLargestExponent + k * kGridStep;
    const double squares = profile.residual_squares(b);
    if (squares < smallest) {
      smallest = squares;
      best = b;
    }
  }
  const double low = std::max(best - kGridStep, -kLargestExponent);
  const double high = std::min(best + kGridStep, kLargestExponent);
  const auto slope = [&](double b) { return profile.half_slope(b); };
  if (slope(best) == 0.0) return best;
  if (slope(low) < 0.0 && slope(high) > 0.0) return root_between(slope, low, high);
  return boost::math::tools::brent_find_minima(
             [&](double b) { return profile.residual_squares(b); }, low, high, 30)
      .first;
}

// Where the residual squares, walking from the best exponent in `direction`, reach `level`.
std::optional<double> profile_limit(const Profile& profile, double best, double level,
                                    double direction) {
  const auto excess = [&](double b) { return profile.residual_squares(b) - level; };
  double inside = best;
  for (double step = 1e-6; std::abs(inside) < kLargestExponent; step *= 2.0) {
    const double outside = std::clamp(best + direction * step, -kLargestExponent, kLargestExponent);
    if (excess(outside) > 0.0) {
      return root_between(excess, std::min(inside, outside), std::max(inside, outside));
    }
    inside = outside;
  }
  return std::nullopt;
}

PowerLaw fit_raw(std::span<const double> trials, std::span<const double> values,
                 double confidence) {
  PowerLaw law;
  law.count = static_cast<int>(values.size());
  double size = 0.0;
  for (const double value : values) size = std::max(size, std::abs(value));
  if (size == 0.0) {
    law.not_identified = true;
    return law;
  }
  std::vector<double> scaled(values.begin(), values.end());
  for (double& value : scaled) value /= size;
  const Profile profile(trials, scaled);

  law.b = best_exponent(profile);
  law.a = profile.a(law.b) * size;
  law.at_bound = std::abs(law.b) > kLargestExponent - 0.5 * kGridStep;
  const auto degrees = static_cast<double>(values.size()) - 2.0;
  const double squares = profile.residual_squares(law.b);
  law.residual_deviation = std::sqrt(squares / degrees) * size;
  const double total = sum_of_squares_about(mean_of(scaled), scaled);
  const double rounding = 1e-26 * static_cast<double>(values.size());
  if (total > rounding) law.r_squared = 1.0 - squares / total;

  // an exact fit leaves no scatter to judge b by
  if (squares > rounding && !law.at_bound) {
    const double f = boost::math::quantile(boost::math::fisher_f(1.0, degrees), confidence);
    const double level = squares * (1.0 + f / degrees);
    const auto low = profile_limit(profile, law.b, level, -1.0);
    const auto high = profile_limit(profile, law.b, level, 1.0);
    if (low && high) law.b_interval = Interval{*low, *high, confidence};
  }
  return law;
}

PowerLaw fit_log_log(std::span<const double> trials, std::span<const double> values,
                     double confidence) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < values.size(); ++i) {
    x.push_back(std::log(trials[i]));
    y.push_back(std::log(values[i]));
  }
  const double mean_x = mean_of(x), mean_y = mean_of(y);
  double xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) xy += (x[i] - mean_x) * (y[i] - mean_y);
  const double xx = sum_of_squares_about(mean_x, x);
  const double slope = xy / xx;
  double squares = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double residual = y[i] - mean_y - slope * (x[i] - mean_x);
    squares += residual * residual;
  }

  PowerLaw law;
  law.scale = PowerLawScale::log_log;
  law.count = static_cast<int>(values.size());
  law.b = -slope;
  law.a = std::exp(mean_y - slope * mean_x);
  const auto degrees = static_cast<double>(values.size()) - 2.0;
  law.residual_deviation = std::sqrt(squares / degrees);
  const double total = sum_of_squares_about(mean_y, y);
  const double rounding = 1e-26 * static_cast<double>(values.size());
  if (total > rounding) law.r_squared = 1.0 - squares / total;
  if (squares > rounding) {
    const double half =
        boost::math::quantile(boost::math::students_t(degrees), 0.5 + 0.5 * confidence) *
        std::sqrt(squares / degrees / xx);
    law.b_interval = Interval{law.b - half, law.b + half, confidence};
  }
  return law;
}

std::optional<base::Error> objection(std::span<const double> trials, std::span<const double> values,
                                     PowerLawScale scale, double confidence) {
  using base::ErrorCode;
  if (trials.size() != values.size()) {
    return base::Error{ErrorCode::invalid_input, "every value needs the number of its trial"};
  }
  if (!all_usable(values) || !all_usable(trials) || !(confidence > 0.0 && confidence < 1.0)) {
    return base::Error{ErrorCode::invalid_input,
                       "a value is not a number that can be computed with"};
  }
  if (std::any_of(trials.begin(), trials.end(), [](double n) { return n < 1.0; })) {
    return base::Error{ErrorCode::invalid_input, "trials are numbered from 1"};
  }
  if (scale == PowerLawScale::log_log &&
      std::any_of(values.begin(), values.end(), [](double v) { return v <= 0.0; })) {
    return base::Error{ErrorCode::invalid_input, "a value that is not positive has no logarithm"};
  }
  if (values.size() < 3) {
    return base::Error{ErrorCode::not_enough_data, "a power law needs at least three trials"};
  }
  if (std::all_of(trials.begin(), trials.end(), [&](double n) { return n == trials[0]; })) {
    return base::Error{ErrorCode::not_enough_data,
                       "a power law needs trials with different numbers"};
  }
  return std::nullopt;
}

}  // namespace

double PowerLaw::value_at(double trial) const { return a * std::pow(trial, -b); }

base::Result<PowerLaw> fit_power_law(std::span<const double> trials, std::span<const double> values,
                                     PowerLawScale scale, double confidence) {
  if (auto error = objection(trials, values, scale, confidence)) return *error;
  PowerLaw law = scale == PowerLawScale::raw ? fit_raw(trials, values, confidence)
                                             : fit_log_log(trials, values, confidence);
  law.learning_rate = std::exp2(-law.b);
  // trial numbers that hardly differ can ask for a value that no double holds
  if (!std::isfinite(law.a) || !std::isfinite(law.b) || !std::isfinite(law.learning_rate)) {
    return base::Error{base::ErrorCode::not_enough_data,
                       "the trials are too close together to fit a power law"};
  }
  return law;
}

}  // namespace assessment
