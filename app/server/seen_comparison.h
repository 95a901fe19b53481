// A comparison of novices with experts as the one who asks may see it: an instructor over the
// people in their groups, a researcher without names, few people by their instructor alone.
#pragma once

#include <string>
#include <vector>

#include "app/session/comparison_data.h"
#include "assessment/comparison.h"
#include "curricula/curriculum.h"
#include "database/people.h"
#include "database/store.h"
#include "sim/base/result.h"

namespace app {

struct ComparisonChoice {
  std::string exercise_id, exercise_title, dataset, dataset_title;
  int people = 0, trials = 0;
};

// The data sets that have a trial, for each exercise.
base::Result<std::vector<ComparisonChoice>> comparison_choices(
    database::Store& store, const curricula::Curriculum& curriculum,
    const database::Person& viewer);

// The rows the viewer may see; may be none.
base::Result<ComparisonData> seen_data(database::Store& store, const curricula::Exercise& exercise,
                                       const std::string& dataset, const database::Person& viewer);

// not_enough_data says why there is nothing to show.
base::Result<assessment::GroupComparison> seen_comparison(const ComparisonData& data,
                                                          const curricula::Exercise& exercise,
                                                          const database::Person& viewer);

}  // namespace app
