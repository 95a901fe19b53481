// The metrics by family, each family in a file of its own. To add a metric, add an entry to the
// table of its family; to add a family, add it here and to metrics.cpp.
#pragma once

#include <optional>
#include <span>

#include "assessment/metrics.h"
#include "assessment/metrics/signals.h"

namespace assessment {

struct Metric {
  MetricDefinition definition;
  // The value in the definition's unit; absent when the metric has no meaning for the recording.
  std::optional<double> (*compute)(const Signals& signals);
};

std::span<const Metric> time_metrics();
std::span<const Metric> path_metrics();
std::span<const Metric> rotation_metrics();
std::span<const Metric> accuracy_metrics();
std::span<const Metric> speed_metrics();
std::span<const Metric> smoothness_metrics();
std::span<const Metric> force_metrics();
std::span<const Metric> handle_metrics();
std::span<const Metric> wall_hit_metrics();

}  // namespace assessment
