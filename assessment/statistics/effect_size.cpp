#include "assessment/statistics/effect_size.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/tools/roots.hpp>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/rank_test.h"

namespace assessment {
namespace {

namespace policies = boost::math::policies;

// Where a series does not converge we want a NaN to look at, not an exception.
using Quiet = policies::policy<policies::domain_error<policies::ignore_error>,
                               policies::pole_error<policies::ignore_error>,
                               policies::overflow_error<policies::ignore_error>,
                               policies::evaluation_error<policies::ignore_error>>;

constexpr double kLargestT = 1000.0;  // beyond it the series of non-central t loses its digits

double share_below(double t, double degrees, double non_centrality) {
  const boost::math::non_central_t_distribution<double, Quiet> distribution(degrees,
                                                                            non_centrality);
  return boost::math::cdf(distribution, t);
}

// The non-centrality at which a share `probability` of non-central t lies below the observed t.
// The share falls from 1 to 0 as the non-centrality rises.
std::optional<double> non_centrality_at(double t, double degrees, double probability) {
  const auto excess = [&](double delta) { return share_below(t, degrees, delta) - probability; };
  double low = t - 2.0, high = t + 2.0;
  double at_low = excess(low), at_high = excess(high);
  for (double step = 4.0; !(at_low > 0.0); step *= 2.0) {
    low -= step;
    if (!std::isfinite(at_low) || step > 16.0 * kLargestT) return std::nullopt;
    at_low = excess(low);
  }
  for (double step = 4.0; !(at_high < 0.0); step *= 2.0) {
    high += step;
    if (!std::isfinite(at_high) || step > 16.0 * kLargestT) return std::nullopt;
    at_high = excess(high);
  }
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      excess, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(44), iterations,
      Quiet());
  const double root = 0.5 * (bracket.first + bracket.second);
  if (!std::isfinite(root)) return std::nullopt;
  return root;
}

// J = Gamma(df / 2) / (sqrt(df / 2) Gamma((df - 1) / 2)), Hedges 1981, equation 6e.
double small_sample_correction(double degrees) {
  return std::exp(std::lgamma(degrees / 2.0) - std::lgamma((degrees - 1.0) / 2.0)) /
         std::sqrt(degrees / 2.0);
}

}  // namespace

base::Result<HedgesG> hedges_g(std::span<const double> first, std::span<const double> second,
                               double confidence) {
  if (first.empty() || second.empty() || first.size() + second.size() < 4) {
    return base::Error{base::ErrorCode::not_enough_data,
                       "an effect size needs values in both groups and four in all"};
  }
  if (!all_usable(first) || !all_usable(second) || !(confidence > 0.0 && confidence < 1.0)) {
    return base::Error{base::ErrorCode::invalid_input,
                       "a value is not a number that can be computed with"};
  }
  const auto n1 = static_cast<double>(first.size());
  const auto n2 = static_cast<double>(second.size());
  const double degrees = n1 + n2 - 2.0;
  const double mean1 = mean_of(first), mean2 = mean_of(second);
  const double pooled = std::sqrt(
      (sum_of_squares_about(mean1, first) + sum_of_squares_about(mean2, second)) / degrees);
  // constant groups leave at most the rounding of their means behind
  if (pooled <= 1e-12 * std::max(std::abs(mean1), std::abs(mean2))) {
    return base::Error{base::ErrorCode::not_enough_data,
                       "nobody differs within the groups, so a standardised difference has no "
                       "scale"};
  }

  HedgesG effect;
  effect.pooled_deviation = pooled;
  effect.cohen_d = (mean1 - mean2) / pooled;
  effect.correction = small_sample_correction(degrees);
  effect.g = effect.correction * effect.cohen_d;
  const double scale = std::sqrt(1.0 / n1 + 1.0 / n2);
  const double t = effect.cohen_d / scale;
  if (std::abs(t) <= kLargestT) {
    const double tail = 0.5 * (1.0 - confidence);
    const auto low = non_centrality_at(t, degrees, 1.0 - tail);
    const auto high = non_centrality_at(t, degrees, tail);
    if (low && high) {
      const double factor = effect.correction * scale;
      effect.interval = Interval{factor * *low, factor * *high, confidence};
    }
  }
  return effect;
}

base::Result<Dominance> dominance(std::span<const double> first, std::span<const double> second) {
  if (first.empty() || second.empty()) {
    return base::Error{base::ErrorCode::not_enough_data,
                       "comparing pairs needs at least one value in each group"};
  }
  if (!all_usable(first) || !all_usable(second)) {
    return base::Error{base::ErrorCode::invalid_input,
                       "a value is not a number that can be computed with"};
  }
  const auto [low1, high1] = std::minmax_element(first.begin(), first.end());
  const auto [low2, high2] = std::minmax_element(second.begin(), second.end());

  // by ranks rather than pair by pair, which large groups could not afford
  const double pairs = static_cast<double>(first.size()) * static_cast<double>(second.size());
  const double first_higher = pairs_won(first, second) / pairs;
  Dominance result;
  result.cliffs_delta = 2.0 * first_higher - 1.0;
  result.first_lower = 1.0 - first_higher;
  result.complete_separation = *high1 < *low2 || *high2 < *low1;
  return result;
}

}  // namespace assessment
