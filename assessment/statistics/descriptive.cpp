#include "assessment/statistics/descriptive.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace assessment {
namespace {

double quantile_of_sorted(std::span<const double> sorted, double probability) {
  assert(!sorted.empty() && probability >= 0.0 && probability <= 1.0);
  const double position = probability * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(position));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double weight = position - static_cast<double>(below);
  // nothing is added at weight 0, so that a whole position gives the value itself
  return sorted[below] + weight * (sorted[above] - sorted[below]);
}

std::vector<double> sorted_copy(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

}  // namespace

bool all_usable(std::span<const double> values) {
  // false for NaN too, which compares with nothing
  return std::all_of(values.begin(), values.end(), [](double v) { return std::abs(v) < 1e150; });
}

double mean_of(std::span<const double> values) {
  assert(!values.empty());
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double sum_of_squares_about(double centre, std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += (value - centre) * (value - centre);
  return sum;
}

double median_of(std::span<const double> values) { return quantile(values, 0.5); }

double quantile(std::span<const double> values, double probability) {
  return quantile_of_sorted(sorted_copy(values), probability);
}

base::Result<Summary> summarise(std::span<const double> values) {
  if (values.empty()) {
    return base::Error{base::ErrorCode::not_enough_data, "there is no value to describe"};
  }
  if (!all_usable(values)) {
    return base::Error{base::ErrorCode::invalid_input,
                       "a value is not a number that can be computed with"};
  }
  const std::vector<double> sorted = sorted_copy(values);
  Summary summary;
  summary.count = static_cast<int>(values.size());
  summary.mean = mean_of(values);
  if (values.size() > 1) {
    summary.standard_deviation = std::sqrt(sum_of_squares_about(summary.mean, values) /
                                           static_cast<double>(values.size() - 1));
  }
  summary.minimum = sorted.front();
  summary.quartile_low = quantile_of_sorted(sorted, 0.25);
  summary.median = quantile_of_sorted(sorted, 0.5);
  summary.quartile_high = quantile_of_sorted(sorted, 0.75);
  summary.maximum = sorted.back();
  return summary;
}

}  // namespace assessment
