#include "assessment/metrics.h"

#include <algorithm>
#include <cmath>

#include "assessment/metrics/family.h"

namespace assessment {
namespace {

std::vector<Metric> gather() {
  std::vector<Metric> metrics;
  for (const auto family :
       {time_metrics(), path_metrics(), rotation_metrics(), accuracy_metrics(), speed_metrics(),
        smoothness_metrics(), force_metrics(), handle_metrics(), wall_hit_metrics()}) {
    metrics.insert(metrics.end(), family.begin(), family.end());
  }
  return metrics;
}

const std::vector<Metric>& registry() {
  static const std::vector<Metric> metrics = gather();
  return metrics;
}

std::vector<MetricDefinition> definitions_of(const std::vector<Metric>& metrics) {
  std::vector<MetricDefinition> definitions;
  definitions.reserve(metrics.size());
  for (const Metric& metric : metrics) definitions.push_back(metric.definition);
  return definitions;
}

}  // namespace

std::span<const MetricDefinition> metric_definitions() {
  static const std::vector<MetricDefinition> definitions = definitions_of(registry());
  return definitions;
}

const MetricDefinition* find_metric(std::string_view id) {
  const auto definitions = metric_definitions();
  const auto found = std::find_if(definitions.begin(), definitions.end(),
                                  [id](const MetricDefinition& d) { return d.id == id; });
  return found == definitions.end() ? nullptr : &*found;
}

std::vector<MetricValue> compute_metrics(const RecordedTrial& trial) {
  std::vector<MetricValue> values;
  const auto signals = derive_signals(trial);
  if (!signals) return values;
  for (const Metric& metric : registry()) {
    const auto value = metric.compute(*signals);
    // absurdly large positions can overflow; such a value means nothing
    if (!value || !std::isfinite(*value)) continue;
    values.push_back({std::string(metric.definition.id), metric.definition.version, *value});
  }
  return values;
}

std::vector<StepTime> step_times(const RecordedTrial& trial) {
  // waiting before the first movement is nobody's step, as in the completion time
  const double begin = first_motion(trial.samples).value_or(0.0);
  std::vector<StepTime> times;
  for (const TrialStep& step : trial.steps) {
    if (!step.done()) continue;
    times.push_back({step.id, std::max(0.0, step.ended - std::max(step.started, begin))});
  }
  return times;
}

}  // namespace assessment
