#include "assessment/statistics/mean_difference.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/students_t.hpp>

#include "assessment/statistics/descriptive.h"

namespace assessment {

base::Result<MeanDifference> welch(std::span<const double> first, std::span<const double> second,
                                   double confidence) {
  if (first.size() < 2 || second.size() < 2) {
    return base::Error{base::ErrorCode::not_enough_data,
                       "the interval of a difference of means needs two values in each group"};
  }
  if (!all_usable(first) || !all_usable(second) || !(confidence > 0.0 && confidence < 1.0)) {
    return base::Error{base::ErrorCode::invalid_input,
                       "a value is not a number that can be computed with"};
  }
  const auto n1 = static_cast<double>(first.size());
  const auto n2 = static_cast<double>(second.size());
  const double mean1 = mean_of(first), mean2 = mean_of(second);
  // squared standard error of each mean
  const double error1 = sum_of_squares_about(mean1, first) / (n1 - 1.0) / n1;
  const double error2 = sum_of_squares_about(mean2, second) / (n2 - 1.0) / n2;
  const double error = std::sqrt(error1 + error2);
  if (error <= 1e-12 * std::max(std::abs(mean1), std::abs(mean2))) {
    return base::Error{base::ErrorCode::not_enough_data,
                       "nobody differs within the groups, so the difference has no interval"};
  }

  MeanDifference result;
  result.difference = mean1 - mean2;
  result.t = result.difference / error;
  const double share1 = error1 / (error1 + error2), share2 = error2 / (error1 + error2);
  result.degrees_of_freedom = 1.0 / (share1 * share1 / (n1 - 1.0) + share2 * share2 / (n2 - 1.0));
  const boost::math::students_t distribution(result.degrees_of_freedom);
  const double half = error * boost::math::quantile(distribution, 0.5 + 0.5 * confidence);
  result.interval = Interval{result.difference - half, result.difference + half, confidence};
  result.p_two_sided =
      2.0 * boost::math::cdf(boost::math::complement(distribution, std::abs(result.t)));
  return result;
}

}  // namespace assessment
