#include "assessment/motion/smoothness.h"

#include "assessment/metrics/family.h"
#include "assessment/statistics/descriptive.h"

namespace assessment {
namespace {

constexpr std::size_t kShortestStroke = 10;  // samples, 0.1 s

// The median over the translate steps that were done, each trimmed to its movement: both measures
// are defined for one discrete movement, and trailing standstill would be taken for roughness.
std::optional<double> median_over_strokes(const Signals& signals,
                                          std::optional<double> (*measure)(std::span<const double>,
                                                                           double)) {
  std::vector<double> values;
  for (const TrialStep& step : signals.trial->steps) {
    if (step.kind != StepKind::translate || !step.done()) continue;
    const IntervalRange range = signals.intervals(step);
    if (range.end <= range.begin) continue;
    const auto stroke = trimmed(
        std::span(signals.tip_speed).subspan(range.begin, range.end - range.begin), kMovingSpeed);
    if (stroke.size() < kShortestStroke) continue;
    if (const auto value = measure(stroke, kSampleRate)) values.push_back(*value);
  }
  return values.empty() ? std::nullopt : std::optional(median_of(values));
}

std::optional<double> sparc_stroke(const Signals& signals) {
  return median_over_strokes(signals, sparc);
}

std::optional<double> ldlj_stroke(const Signals& signals) {
  return median_over_strokes(signals, log_dimensionless_jerk);
}

constexpr Metric kMetrics[] = {
    {{"sparc_stroke", 1, "", Direction::higher_is_better, "Smoothness (SPARC)",
      "Smoothness of the tip's movement, median over the strokes. Negative; closer to zero is "
      "smoother. Compare it within one exercise only."},
     sparc_stroke},
    {{"ldlj_stroke", 1, "", Direction::higher_is_better, "Smoothness (log jerk)",
      "Log dimensionless jerk of the tip's movement, median over the strokes. Negative; closer to "
      "zero is smoother. Compare it within one exercise only."},
     ldlj_stroke}};

}  // namespace

std::span<const Metric> smoothness_metrics() { return kMetrics; }

}  // namespace assessment
