// What lists and charts need of many trials at once, without reading them one by one.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "database/store.h"

namespace database {

// How many critical errors each trial of a person has, by the trial's id; trials without one are
// left out. One query.
base::Result<std::map<std::string, int>> critical_errors(Store& store,
                                                         const std::string& person_id);

// The mean of one expert's trials of an exercise, in the unit of the metric.
struct ExpertMean {
  std::string exercise_id, metric;
  int version = 0;  // of the metric
  double mean = 0.0;
};
// Live people who were experts when they made the trial; completed live trials, without voided and
// interrupted ones. One row per exercise, metric, version and person, ordered so. One query.
base::Result<std::vector<ExpertMean>> expert_means(Store& store);

}  // namespace database
