// Small pieces of the wire that several answers share.
#pragma once

#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

#include "reports/chart.h"

namespace app {

nlohmann::json to_json(const reports::Table& table);
nlohmann::json to_json(const reports::Chart& chart);
nlohmann::json to_json(const std::vector<reports::Chart>& charts);

// A number, or null: also for one that JSON cannot say.
nlohmann::json number_or_null(const std::optional<double>& value);

// Every metric there is, as the wire's MetricInfo.
nlohmann::json metrics_json();

}  // namespace app
