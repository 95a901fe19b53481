#include "reports/standing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reports/number.h"

namespace reports {
namespace {

std::optional<double> percent_change(double from, double to) {
  if (from == 0.0) return std::nullopt;
  return 100.0 * (to - from) / std::abs(from);
}

}  // namespace

Standing standing_of(const ProgressChart& chart) {
  std::vector<double> values;
  for (const TrialPoint& point : chart.points) {
    if (point.counted) values.push_back(point.value);
  }
  Standing standing;
  if (values.empty()) return standing;
  const bool lower = chart.direction == assessment::Direction::lower_is_better;
  standing.last = values.back();
  standing.best = lower ? *std::min_element(values.begin(), values.end())
                        : *std::max_element(values.begin(), values.end());
  if (values.size() > 1) {
    standing.previous = values[values.size() - 2];
    standing.change_to_previous_percent = percent_change(*standing.previous, values.back());
    standing.change_to_first_percent = percent_change(values.front(), values.back());
  }
  return standing;
}

std::string change_words(std::optional<double> percent, assessment::Direction direction) {
  if (!percent) return "\u2013";
  const std::string size = fixed(std::abs(*percent), 0);
  if (size == "0") return "the same";
  const bool lower = direction == assessment::Direction::lower_is_better;
  const bool better = (*percent < 0.0) == lower;
  return size + " % " + (*percent < 0.0 ? "lower" : "higher") + (better ? ", better" : ", worse");
}

}  // namespace reports
