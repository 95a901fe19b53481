// What the hand feels: force along and torque about the handle.
#include <algorithm>
#include <cmath>

#include "assessment/metrics/breach.h"
#include "assessment/metrics/family.h"

namespace assessment {
namespace {

std::optional<double> largest_force(const Signals& signals) {
  double largest = value_at_breach(*signals.trial, "handle_force_max_n");
  for (const Sample& sample : signals.trial->samples) {
    largest = std::max({largest, std::abs(sample.handle_force), sample.handle_force_peak});
  }
  return largest;
}

std::optional<double> largest_torque(const Signals& signals) {
  double largest = value_at_breach(*signals.trial, "torque_max_n_mm");
  for (const Sample& sample : signals.trial->samples) {
    largest = std::max(largest, std::abs(sample.handle_torque));
  }
  return largest;
}

constexpr Metric kMetrics[] = {
    {{"handle_force_max_n", 1, "N", Direction::lower_is_better, "Peak handle force",
      "The largest push or pull felt at the handle."},
     largest_force},
    {{"torque_max_n_mm", 1, "N mm", Direction::lower_is_better, "Peak handle torque",
      "The largest torque felt at the handle."},
     largest_torque}};

}  // namespace

std::span<const Metric> handle_metrics() { return kMetrics; }

}  // namespace assessment
