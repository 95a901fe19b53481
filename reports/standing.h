// One metric of one exercise in numbers: the last trial, the one before, the best, the change.
#pragma once

#include <optional>
#include <string>

#include "reports/progress_charts.h"

namespace reports {

struct Standing {
  std::optional<double> last, previous, best;        // in the chart's unit
  std::optional<double> change_to_previous_percent;  // positive: the value rose
  std::optional<double> change_to_first_percent;
};

// Of the completed trials that count. A change from zero has no percentage.
Standing standing_of(const ProgressChart& chart);

// "20 % lower, better": the size of a change, its sense, and whether that is better. A dash without
// one.
std::string change_words(std::optional<double> percent, assessment::Direction direction);

}  // namespace reports
