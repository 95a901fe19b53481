// Fetches what a comparison of novices with experts stands on. Published, simulated and live
// trials are never pooled: one call, one of them.
#pragma once

#include <string>
#include <vector>

#include "assessment/comparison.h"
#include "curricula/curriculum.h"
#include "database/store.h"
#include "reports/comparison_report.h"

namespace app {

// The data sets one can ask for: paper, live, simulated.
bool is_dataset(const std::string& name);

struct ComparisonData {
  std::vector<assessment::TrialValue> rows;  // time_s of finished trials that count
  reports::ComparisonSubject subject;
};

// Completed trials, without voided and interrupted ones. A person stays in the group of the level
// that counted at the first of them. Fails with invalid_input for an unknown data set.
base::Result<ComparisonData> comparison_data(database::Store& store,
                                             const curricula::Exercise& exercise,
                                             const std::string& dataset);

}  // namespace app
