#include <algorithm>

#include "reports/comparison_parts.h"

namespace reports {

ValueRange range_of(const assessment::GroupComparison& comparison) {
  ValueRange range{1e300, -1e300};
  for (const assessment::ParticipantResult& person : comparison.participants) {
    range.low = std::min(range.low, person.summary.minimum);
    range.high = std::max(range.high, person.summary.maximum);
  }
  if (range.low > range.high) return {0.0, 1.0};
  if (range.high <= range.low) range.high = range.low + 1.0;
  return range;
}

std::string counted(int count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::vector<Chart> comparison_charts(const assessment::GroupComparison& comparison,
                                     const ComparisonSubject& subject) {
  return {group_curves(comparison, subject, true), group_curves(comparison, subject, false),
          participant_means(comparison, subject), effect_chart(comparison),
          p_floor_chart(comparison)};
}

}  // namespace reports
