// Published versions of curricula and their exercises, kept for ever: a trial points at the
// exercise version it was made under.
#pragma once

#include <string>
#include <vector>

#include "database/store.h"

namespace database {

struct ExerciseVersion {
  std::string id;           // of the row
  std::string exercise_id;  // linear
  int version = 1;
  std::string yaml;  // the exercise's own text
};

// A bound as it was at publishing, in the unit of its metric.
struct BenchmarkVersion {
  std::string id;            // linear_time
  std::string metric, rule;  // time_s; fixed | mean_plus_k_sd | ...
  bool provisional = false;
  double value = 0.0;
  std::string dataset;  // where it was derived from, or empty
};

struct CurriculumVersion {
  std::string row_id;
  std::string curriculum_id;         // vascular-basics
  std::string version;               // 1.0.0
  std::string sha256, yaml, status;  // draft | published | retired
  std::string published_utc;
  std::vector<ExerciseVersion> exercises;
  std::vector<BenchmarkVersion> benchmarks;
};

// Stores a version and its exercises; gives what is stored, with the ids of the rows. The same id,
// version and hash again is no error and publishes a stored draft, but never brings back a
// retired version. Another hash under a stored version is `conflict`. published_utc empty: now.
base::Result<CurriculumVersion> publish_curriculum(Store& store, const CurriculumVersion& version,
                                                   const std::string& actor);
base::Result<std::vector<CurriculumVersion>> curriculum_versions(
    Store& store);  // in the order stored
// Newest published version of a curriculum; not_found.
base::Result<CurriculumVersion> current_curriculum(Store& store, const std::string& curriculum_id);
// The hash of that version's text alone, for whoever keeps the text; not_found.
base::Result<std::string> current_curriculum_sha256(Store& store, const std::string& curriculum_id);
// An exercise of the newest published version of a curriculum; not_found.
base::Result<ExerciseVersion> current_exercise(Store& store, const std::string& curriculum_id,
                                               const std::string& exercise_id);

// By the id of its row, whatever became of its curriculum; not_found.
base::Result<ExerciseVersion> exercise_version(Store& store, const std::string& row_id);

// Enrols a person in a curriculum version's curriculum; the existing enrolment when there is one.
base::Result<std::string> enrol(Store& store, const std::string& person_id,
                                const std::string& curriculum_id);

}  // namespace database
