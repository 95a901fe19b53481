// Published versions of curricula and their exercises, kept for ever: a trial points at the
// exercise version it was made under.
#pragma once

#include <string>
#include <vector>

#include "database/store.h"

namespace database {

struct ExerciseVersion {
  std::string id;             // of the row
  std::string exercise_id;    // linear
  int version = 1;
  std::string yaml;           // the exercise's own text
};

struct CurriculumVersion {
  std::string row_id;
  std::string curriculum_id;  // vascular-basics
  std::string version;        // 1.0.0
  std::string sha256, yaml, status;  // draft | published | retired
  std::string published_utc;
  std::vector<ExerciseVersion> exercises;
};

// Stores a version and its exercises. The same id, version and hash again is no error; another
// hash under a stored version is `conflict`.
base::Result<CurriculumVersion> publish_curriculum(Store& store, const CurriculumVersion& version,
                                                   const std::string& actor);
base::Result<std::vector<CurriculumVersion>> curriculum_versions(Store& store);
// Newest published version of a curriculum; not_found.
base::Result<CurriculumVersion> current_curriculum(Store& store, const std::string& curriculum_id);
// The row id of an exercise of the newest published version; not_found.
base::Result<ExerciseVersion> current_exercise(Store& store, const std::string& exercise_id);

// Enrols a person in a curriculum version's curriculum; the existing enrolment when there is one.
base::Result<std::string> enrol(Store& store, const std::string& person_id,
                                const std::string& curriculum_id);

}  // namespace database
