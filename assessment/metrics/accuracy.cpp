// How precisely each step's target was met: overshoot and settling.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "assessment/metrics/family.h"

namespace assessment {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;  // per radian

// The samples of one step, as the distance still to go: positive before the target, negative past
// it, in the direction in which the step had to go.
struct Approach {
  std::vector<double> times;
  std::vector<double> to_go;
};

double handle_value(const Sample& sample, StepKind kind) {
  return kind == StepKind::rotate ? sample.handle_rotation : sample.handle_axial;
}

// Empty for a step that starts within its tolerance: it has no direction.
Approach approach(const Signals& signals, const TrialStep& step) {
  Approach result;
  if (step.kind == StepKind::hold) return result;
  const auto& samples = signals.trial->samples;
  const auto first =
      std::lower_bound(signals.times.begin(), signals.times.end(), step.started - 1e-9) -
      signals.times.begin();
  const double end = signals.end_of(step) + 1e-9;
  double direction = 0.0;
  for (auto i = static_cast<std::size_t>(first); i < samples.size() && signals.times[i] <= end;
       ++i) {
    const double gap = step.target - handle_value(samples[i], step.kind);
    if (direction == 0.0) {
      if (std::abs(gap) <= step.tolerance) return result;
      direction = gap > 0.0 ? 1.0 : -1.0;
    }
    result.times.push_back(signals.times[i]);
    result.to_go.push_back(direction * gap);
  }
  return result;
}

// The largest over the steps of a kind; absent without such a step.
std::optional<double> largest_overshoot(const Signals& signals, StepKind kind) {
  std::optional<double> largest;
  for (const TrialStep& step : signals.begun()) {
    if (step.kind != kind) continue;
    const Approach way = approach(signals, step);
    if (way.to_go.empty()) continue;
    const double past = -*std::min_element(way.to_go.begin(), way.to_go.end());
    largest = std::max({0.0, past, largest.value_or(0.0)});
  }
  return largest;
}

std::optional<double> overshoot_mm(const Signals& signals) {
  return largest_overshoot(signals, StepKind::translate);
}

std::optional<double> overshoot_deg(const Signals& signals) {
  const auto angle = largest_overshoot(signals, StepKind::rotate);
  return angle ? std::optional(*angle * kDegrees) : std::nullopt;
}

// From first reaching the target's tolerance (or passing it) to the last time of coming back in.
double settle_time(const Approach& way, double tolerance) {
  std::optional<double> reached;
  double settled = 0.0;
  for (std::size_t i = 0; i < way.to_go.size(); ++i) {
    if (!reached) {
      if (way.to_go[i] > tolerance) continue;
      reached = way.times[i];
      settled = way.times[i];
    }
    const bool outside = std::abs(way.to_go[i]) > tolerance;
    if (outside && i + 1 < way.times.size()) settled = way.times[i + 1];
  }
  return reached ? settled - *reached : 0.0;
}

std::optional<double> settle_s(const Signals& signals) {
  std::optional<double> total;
  for (const TrialStep& step : signals.trial->steps) {
    if (!step.done()) continue;
    const Approach way = approach(signals, step);
    if (way.to_go.empty()) continue;
    total = total.value_or(0.0) + settle_time(way, step.tolerance);
  }
  return total;
}

constexpr Metric kMetrics[] = {
    {{"overshoot_mm", 1, "mm", Direction::lower_is_better, "Overshoot",
      "The farthest the handle was fed past the target of a step."},
     overshoot_mm},
    {{"overshoot_deg", 1, "deg", Direction::lower_is_better, "Rotation overshoot",
      "The farthest the handle was turned past the target of a step."},
     overshoot_deg},
    {{"settle_s", 1, "s", Direction::lower_is_better, "Settling time",
      "Time between first reaching the target of a step and staying within its tolerance, all "
      "steps added up."},
     settle_s}};

}  // namespace

std::span<const Metric> accuracy_metrics() { return kMetrics; }

}  // namespace assessment
