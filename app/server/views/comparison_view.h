// Novices against experts, as the instructor's page shows it.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "assessment/comparison.h"
#include "reports/comparison_report.h"

namespace app {

nlohmann::json comparison_json(const assessment::GroupComparison& comparison,
                               const reports::ComparisonSubject& subject);
// A comparison that cannot be made or shown, and why.
nlohmann::json no_comparison_json(const reports::ComparisonSubject& subject,
                                  const std::string& why);

}  // namespace app
