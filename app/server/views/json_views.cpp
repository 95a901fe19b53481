#include "app/server/views/json_views.h"

#include <cmath>

#include "assessment/metrics.h"

namespace app {

using nlohmann::json;

json to_json(const reports::Table& table) {
  return {{"columns", table.columns}, {"rows", table.rows}};
}

json to_json(const reports::Chart& chart) {
  return {{"id", chart.id},
          {"title", chart.title},
          {"summary", chart.summary},
          {"svg", chart.svg},
          {"table", to_json(chart.table)}};
}

json to_json(const std::vector<reports::Chart>& charts) {
  json list = json::array();
  for (const reports::Chart& chart : charts) list.push_back(to_json(chart));
  return list;
}

json number_or_null(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return *value;
}

json metrics_json() {
  json metrics = json::array();
  for (const assessment::MetricDefinition& metric : assessment::metric_definitions()) {
    const bool lower = metric.direction == assessment::Direction::lower_is_better;
    metrics.push_back({{"id", metric.id},
                       {"version", metric.version},
                       {"title", metric.title},
                       {"unit", metric.unit},
                       {"direction", lower ? "lower" : "higher"},
                       {"definition", metric.definition}});
  }
  return metrics;
}

}  // namespace app
