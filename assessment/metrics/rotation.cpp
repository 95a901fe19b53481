#include "assessment/motion/rotation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assessment/metrics/family.h"

namespace assessment {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;  // per radian
constexpr double kDeadBand = 2.0;                      // degrees

std::vector<double> handle_angle_deg(const Signals& signals) {
  std::vector<double> angle;
  angle.reserve(signals.trial->samples.size());
  for (const Sample& sample : signals.trial->samples) {
    angle.push_back(sample.handle_rotation * kDegrees);
  }
  return angle;
}

std::optional<double> rotation_total(const Signals& signals) {
  return total_variation(handle_angle_deg(signals));
}

std::optional<double> rotation_economy(const Signals& signals) {
  double commanded = 0.0, turned = 0.0;
  double from = signals.trial->samples.front().handle_rotation;
  for (const TrialStep& step : signals.trial->steps) {
    if (step.kind != StepKind::rotate || !step.done()) continue;
    commanded += std::abs(step.target - from);
    from = step.target;
    const IntervalRange range = signals.intervals(step);
    for (std::size_t i = range.begin; i < range.end; ++i) turned += std::abs(signals.turn[i]);
  }
  if (commanded == 0.0 || turned == 0.0) return std::nullopt;
  return std::min(1.0, commanded / turned);
}

std::optional<double> reversals(const Signals& signals) {
  return count_reversals(handle_angle_deg(signals), kDeadBand);
}

constexpr Metric kMetrics[] = {
    {{"rotation_total_deg", 1, "deg", Direction::lower_is_better, "Total rotation",
      "How far the handle was turned in all, to and fro added up."},
     rotation_total},
    {{"rotation_economy", 1, "", Direction::higher_is_better, "Rotation economy",
      "The rotation the task asked for divided by the rotation of the handle. 1 is without "
      "detour."},
     rotation_economy},
    {{"reversals", 1, "", Direction::lower_is_better, "Reversals",
      "How often the direction of rotation changed by more than 2 degrees."},
     reversals}};

}  // namespace

std::span<const Metric> rotation_metrics() { return kMetrics; }

}  // namespace assessment
