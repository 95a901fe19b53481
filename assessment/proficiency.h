// When a person counts as proficient in an exercise: so many passes in a row.
#pragma once

#include <span>
#include <string>

#include "assessment/rule.h"

namespace assessment {

struct ProficiencyRule {
  int consecutive = 2;  // passes in a row
  int additional = 0;   // further passes after that, anywhere
  int min_trials = 0;
  int max_trials = 0;  // 0: no limit
};

enum class ExerciseStatus {
  locked,
  available,
  in_progress,
  practised,
  proficient,
  lapsed,
  waived,
  exhausted
};
const char* word(ExerciseStatus status);

// One stored trial as progression sees it.
struct TrialOutcome {
  Outcome outcome = Outcome::invalid;
  bool voided = false;
  bool interrupted = false;  // shown, not counted
  bool counts() const { return !voided && !interrupted && outcome != Outcome::invalid; }
};

struct Progress {
  ExerciseStatus status = ExerciseStatus::available;
  int started = 0;  // all trials
  int counted = 0;  // those that count
  int passes = 0;
  int in_a_row = 0;      // current run of passes
  std::string sentence;  // "1 of 2 passes in a row"
};

// The one function that decides what is shown and what the server enforces.
// `outcomes` in the order the trials were made; `unlocked`: the prerequisites are met.
Progress progress_of(const ProficiencyRule& rule, std::span<const TrialOutcome> outcomes,
                     bool unlocked);

}  // namespace assessment
