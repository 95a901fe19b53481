#include "assessment/metrics/family.h"

namespace assessment {
namespace {

std::optional<double> completion_time(const Signals& signals) {
  // time spent on a task that was not finished is not the time it takes
  if (!signals.first_motion || signals.trial->end_reason != EndReason::completed ||
      !all_steps_done(*signals.trial) || signals.end < *signals.first_motion) {
    return std::nullopt;
  }
  return signals.end - *signals.first_motion;
}

constexpr Metric kMetrics[] = {
    {{"time_s", 1, "s", Direction::lower_is_better, "Completion time",
      "Time from the first movement of the handle to the end of the last step."},
     completion_time}};

}  // namespace

std::span<const Metric> time_metrics() { return kMetrics; }

}  // namespace assessment
