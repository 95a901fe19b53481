// Where a person stands in a curriculum: what is open, what is locked and why, what comes next.
// This is the one place that decides what is shown and what the server enforces.
//
// A pure function of the curriculum, the stored trials and today's date. It knows no clock, no
// database and no person.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "assessment/proficiency.h"
#include "curricula/curriculum.h"
#include "sim/base/result.h"

namespace curricula {

// One stored trial. `date` is the local calendar day it was begun, e.g. "2026-03-31": the daily
// maximum counts by it. Only equality with `today` matters.
struct PastTrial {
  assessment::TrialOutcome outcome;
  std::string date;
};

// A person's trials of one exercise, in the order they were made.
struct ExerciseHistory {
  std::string exercise_id;
  std::vector<PastTrial> trials;
};

struct ExerciseState {
  std::string exercise_id;
  std::string block_id;           // empty when the plan does not name the exercise
  assessment::Progress progress;  // status, counts and their sentence
  bool may_start = false;         // a trial for the record may begin now
  std::string why_not;            // one sentence; empty when may_start
};

struct BlockState {
  std::string block_id;
  bool unlocked = true;        // the block before is proficient
  bool proficient = false;     // every exercise of it is
  int trials_today = 0;        // begun today, voided ones left out
  int max_trials_per_day = 0;  // 0: no limit
};

struct Progression {
  std::vector<ExerciseState> exercises;  // in the plan's order, then those outside the plan
  std::vector<BlockState> blocks;        // in the plan's order
  std::string next;                      // exercise to do next; empty when none may start
  std::string sentence;                  // what to do next, or why nothing is open

  const ExerciseState* find(const std::string& exercise_id) const;  // null when unknown
  const BlockState* find_block(const std::string& block_id) const;  // null when unknown
};

// Exercises without a history count as never tried; histories of unknown exercises are ignored.
Progression progression_of(const Curriculum& curriculum, std::span<const ExerciseHistory> histories,
                           const std::string& today);

// May a trial for the record begin? Fails with the sentence to show: `not_found` for an exercise
// the curriculum does not have, `denied` for one that is locked, exhausted, over the daily
// maximum, or of a curriculum that is not published.
base::Status may_start(const Curriculum& curriculum, std::span<const ExerciseHistory> histories,
                       const std::string& today, const std::string& exercise_id);

}  // namespace curricula
