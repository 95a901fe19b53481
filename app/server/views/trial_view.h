// Trials on the wire: a row in a list, and the debrief of one.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/session/scene.h"
#include "curricula/curriculum.h"
#include "database/store.h"
#include "database/trials.h"
#include "reports/chart.h"

namespace app {

// `exercise`: gives the target time; null when unknown. Published trials come from another
// apparatus and have no target here.
nlohmann::json trial_row_json(const database::StoredTrial& trial,
                              const curricula::Exercise* exercise, int critical_errors);

// Newest first. `critical_errors`: of database::critical_errors for the person.
nlohmann::json trial_rows_json(const std::vector<const database::StoredTrial*>& trials,
                               const curricula::Exercise* exercise,
                               const std::map<std::string, int>& critical_errors);

// What a trial was judged by, and what was measured in it.
nlohmann::json criteria_json(const std::vector<assessment::Criterion>& criteria);
nlohmann::json metrics_json(const std::vector<assessment::MetricValue>& metrics);

// All of the debrief but the progress of the person. `exercise`: the version the trial was made
// under, or null when the trial was not made here.
base::Result<nlohmann::json> debrief_json(database::Store& store,
                                          const database::StoredTrial& trial,
                                          const curricula::Exercise* exercise);

}  // namespace app
