// How a person gets on: the plan, the next exercise, the curve of each exercise, the row in a list
// of people.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "app/server/expert_bands.h"
#include "app/server/training_record.h"
#include "curricula/catalogue.h"
#include "database/people.h"
#include "database/store.h"

namespace app {

nlohmann::json exercise_card_json(const curricula::Exercise& exercise,
                                  const curricula::ExerciseState& state);

// What a trainee sees first.
base::Result<nlohmann::json> training_json(database::Store& store, const TrainingRecord& record,
                                           const curricula::Library& library,
                                           const ExpertBands& bands);

// Every exercise the person has tried or may try, with curve and trials. `you`: it is read by the
// person it is about.
base::Result<nlohmann::json> exercises_progress_json(database::Store& store,
                                                     const TrainingRecord& record,
                                                     const database::Person& person, bool you,
                                                     const ExpertBands& bands);

nlohmann::json person_row_json(const database::Person& person, const TrainingRecord& record);

}  // namespace app
