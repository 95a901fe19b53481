// Every metric the program knows, and their values for one recorded trial. Each metric is a pure
// function of the recording in a file of its own under assessment/metrics/.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "assessment/trial.h"

namespace assessment {

enum class Direction { lower_is_better, higher_is_better };

struct MetricDefinition {
  std::string_view id;    // time_s
  int version = 1;        // rises when the formula or a threshold changes
  std::string_view unit;  // "s", "mm", "" for a ratio
  Direction direction = Direction::lower_is_better;
  std::string_view title;       // Completion time
  std::string_view definition;  // one or two plain sentences for the person measured
};

struct MetricValue {
  std::string id;
  int version = 1;
  double value = 0.0;  // in the metric's unit
};

// In the order they are shown.
std::span<const MetricDefinition> metric_definitions();
const MetricDefinition* find_metric(std::string_view id);  // null when unknown

// All metrics that this recording supports, in the order of metric_definitions(). A metric that
// has no meaning for the recording (rotation economy of a task without rotation) is left out.
std::vector<MetricValue> compute_metrics(const RecordedTrial& trial);

// Seconds each step took, in the order of trial.steps; steps that were not done are left out.
struct StepTime {
  std::string step_id;
  double seconds = 0.0;
};
std::vector<StepTime> step_times(const RecordedTrial& trial);

}  // namespace assessment
