// How one person gets on in each exercise, as values: the page, the report and the table are all
// made from this.
#pragma once

#include <string>
#include <vector>

#include "app/server/expert_bands.h"
#include "app/server/training_record.h"
#include "curricula/curriculum.h"
#include "curricula/progression.h"
#include "database/trials.h"
#include "reports/progress_charts.h"

namespace app {

struct MetricProgress {
  std::string metric;
  reports::ProgressChart chart;  // titled with its unit
};

struct ExerciseProgress {
  const curricula::Exercise* exercise = nullptr;     // of the record's curriculum
  const curricula::ExerciseState* state = nullptr;   // of the record
  std::vector<const database::StoredTrial*> trials;  // of the record, by ordinal
  std::string headline;
  reports::ProgressChart times, forces;
  std::vector<MetricProgress> metrics;  // what the exercise records, in its order
};

// Every exercise of the record's curriculum. `record` must outlive the answer. `you`: it is read by
// the person it is about.
std::vector<ExerciseProgress> exercises_progress(const TrainingRecord& record,
                                                 const std::string& who, bool you,
                                                 const ExpertBands& bands);

// Time over trials, and the highest force where any trial has one.
std::vector<reports::Chart> large_charts(const ExerciseProgress& progress);

// The time of each completed trial against the target.
reports::ProgressChart time_chart(const curricula::Exercise& exercise,
                                  const std::vector<const database::StoredTrial*>& trials,
                                  const std::string& who, const ExpertBands& bands);

// Neither voided nor interrupted.
bool counts(const database::StoredTrial& trial);

}  // namespace app
