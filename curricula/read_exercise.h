// Reads one exercise of a curriculum.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "curricula/fields.h"

namespace curricula {

// What `defaults:` says for every exercise that does not say otherwise.
struct ExerciseDefaults {
  Attempt attempt;
  std::vector<std::string> feedback_during, feedback_after;
};

ExerciseDefaults read_defaults(const YamlNode& node, Problems& problems);

// An exercise and where its parts stand, for the checks across exercises.
struct ExerciseDraft {
  struct Requirement {
    std::string exercise;
    const YamlNode* at = nullptr;
  };
  Exercise exercise;
  const YamlNode* node = nullptr;
  const YamlNode* id_node = nullptr;  // null when there is no id
  std::vector<Requirement> requirements;
  bool has_record = false, has_pass = false, has_proficiency = false;
};

struct ExerciseContext {
  const Catalogue& catalogue;
  std::span<const Benchmark> benchmarks;
  const ExerciseDefaults& defaults;
  bool truncated = false;  // a syntax error hides the rest of the file
};

ExerciseDraft read_exercise(const YamlNode& node, const ExerciseContext& context,
                            Problems& problems);

}  // namespace curricula
