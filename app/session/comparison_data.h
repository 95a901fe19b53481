// Fetches what a comparison of novices with experts stands on. Published, simulated and live
// trials are never pooled: one call, one of them.
#pragma once

#include <functional>
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

// Whose trials may be counted, by the person's id.
using PersonFilter = std::function<bool(const std::string& person_id)>;

// Completed trials, without voided and interrupted ones. A person stays in the group of the level
// that counted at the first of them. Without a filter everybody is counted. Fails with
// invalid_input for an unknown data set.
base::Result<ComparisonData> comparison_data(database::Store& store,
                                             const curricula::Exercise& exercise,
                                             const std::string& dataset,
                                             const PersonFilter& may_count = {});

}  // namespace app
