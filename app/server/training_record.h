// Where one person stands: the curriculum, the stored trials, and what follows from both.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/server/site.h"
#include "curricula/curriculum.h"
#include "curricula/progression.h"
#include "database/store.h"
#include "database/trials.h"

namespace app {

struct TrainingRecord {
  std::shared_ptr<const curricula::Curriculum> curriculum;  // shared: with the site
  std::vector<database::StoredTrial> trials;                // finished; by exercise, then ordinal
  std::vector<curricula::ExerciseHistory> histories;
  std::string today;  // local calendar day
  curricula::Progression progression;

  std::vector<const database::StoredTrial*> trials_of(const std::string& exercise_id) const;
};

base::Result<TrainingRecord> training_record(database::Store& store, Site& site,
                                             const std::string& person_id);
// The same, for many people of one curriculum.
base::Result<TrainingRecord> training_record(
    database::Store& store, std::shared_ptr<const curricula::Curriculum> curriculum,
    const std::string& person_id);

// The value of a metric in a stored trial.
std::optional<double> metric_value(const database::StoredTrial& trial, const std::string& metric);

// The local calendar day of a UTC instant, "2026-03-31"; its UTC day when it cannot be read.
std::string local_day(const std::string& utc);

}  // namespace app
