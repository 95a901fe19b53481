#include <algorithm>
#include <cmath>

#include "assessment/metrics/family.h"

namespace assessment {
namespace {

std::optional<double> tip_path(const Signals& signals) { return path_length(signals.tip); }

// Commanded travel over the handle's travel, in the translate steps that were done. The straight
// line between the end points would be the wrong ideal: the task itself goes to and fro.
std::optional<double> handle_economy(const Signals& signals) {
  const auto& samples = signals.trial->samples;
  double commanded = 0.0, travelled = 0.0;
  double from = samples.front().handle_axial;
  for (const TrialStep& step : signals.trial->steps) {
    if (step.kind != StepKind::translate || !step.done()) continue;
    commanded += std::abs(step.target - from);
    from = step.target;
    const IntervalRange range = signals.intervals(step);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      travelled += std::abs(samples[i + 1].handle_axial - samples[i].handle_axial);
    }
  }
  if (commanded == 0.0 || travelled == 0.0) return std::nullopt;
  // stopping short by the tolerance can save a little travel
  return std::min(1.0, commanded / travelled);
}

constexpr Metric kMetrics[] = {
    {{"path_length_mm", 1, "mm", Direction::lower_is_better, "Path length",
      "Length of the way the tip of the instrument went, without tremor above 8 Hz."},
     tip_path},
    {{"path_economy", 1, "", Direction::higher_is_better, "Path economy",
      "The travel the task asked for divided by the travel of the handle. 1 is without detour."},
     handle_economy}};

}  // namespace

std::span<const Metric> path_metrics() { return kMetrics; }

}  // namespace assessment
