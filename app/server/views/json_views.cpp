#include "app/server/views/json_views.h"

#include <cmath>

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

}  // namespace app
