#include "assessment/proficiency.h"

#include <algorithm>

#include "assessment/words.h"

namespace assessment {
namespace {

constexpr Word<ExerciseStatus> kStatuses[] = {
    {ExerciseStatus::locked, "locked"},           {ExerciseStatus::available, "available"},
    {ExerciseStatus::in_progress, "in_progress"}, {ExerciseStatus::practised, "practised"},
    {ExerciseStatus::proficient, "proficient"},   {ExerciseStatus::lapsed, "lapsed"},
    {ExerciseStatus::waived, "waived"},           {ExerciseStatus::exhausted, "exhausted"}};

// Walks through the counted trials and notes when the rule is met.
struct Tally {
  const ProficiencyRule& rule;
  int counted = 0;
  int passes = 0;
  int in_a_row = 0;
  int additional = 0;  // passes after the row was complete
  bool row_complete = false;
  int proficient_after = 0;  // counted trials it took, 0: not yet

  int needed_in_a_row() const { return std::max(1, rule.consecutive); }
  bool used_up() const { return rule.max_trials > 0 && counted >= rule.max_trials; }

  void count(bool passed) {
    // trials beyond the limit cannot make up for those within it
    const bool within = !used_up();
    ++counted;
    if (passed) ++passes;
    in_a_row = passed ? in_a_row + 1 : 0;
    if (!within || proficient_after > 0) return;
    if (row_complete && passed) ++additional;
    if (in_a_row >= needed_in_a_row()) row_complete = true;
    if (row_complete && additional >= rule.additional && counted >= rule.min_trials) {
      proficient_after = counted;
    }
  }
};

std::string counted_words(int count, const char* noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

// "1 of 2 passes in a row", and what else is still missing.
std::string row_words(const Tally& tally) {
  const int needed = tally.needed_in_a_row();
  if (!tally.row_complete) {
    return needed == 1 ? "no pass yet"
                       : std::to_string(tally.in_a_row) + " of " + std::to_string(needed) +
                             " passes in a row";
  }
  std::string text =
      needed == 1 ? "one pass reached" : std::to_string(needed) + " passes in a row reached";
  if (tally.additional < tally.rule.additional) {
    text += ", " + std::to_string(tally.additional) + " of " +
            std::to_string(tally.rule.additional) + " further passes";
  }
  if (tally.counted < tally.rule.min_trials) {
    text += ", " + std::to_string(tally.counted) + " of at least " +
            std::to_string(tally.rule.min_trials) + " trials";
  }
  return text;
}

std::string sentence_of(ExerciseStatus status, const Tally& tally) {
  switch (status) {
    case ExerciseStatus::locked:
      return "locked until the exercises before it are done";
    case ExerciseStatus::proficient:
      return "proficient after " + counted_words(tally.proficient_after, "trial");
    case ExerciseStatus::exhausted:
      return "all " + std::to_string(tally.rule.max_trials) + " trials are used up, " +
             row_words(tally);
    default:
      return row_words(tally);
  }
}

}  // namespace

const char* word(ExerciseStatus status) { return word_of<ExerciseStatus>(kStatuses, status); }

Progress progress_of(const ProficiencyRule& rule, std::span<const TrialOutcome> outcomes,
                     bool unlocked) {
  Tally tally{rule};
  for (const TrialOutcome& outcome : outcomes) {
    if (outcome.counts()) tally.count(outcome.outcome == Outcome::passed);
  }
  Progress progress;
  progress.started = static_cast<int>(outcomes.size());
  progress.counted = tally.counted;
  progress.passes = tally.passes;
  progress.in_a_row = tally.in_a_row;
  if (tally.proficient_after > 0) {
    progress.status = ExerciseStatus::proficient;
  } else if (!unlocked) {
    progress.status = ExerciseStatus::locked;
  } else if (tally.used_up()) {
    progress.status = ExerciseStatus::exhausted;
  } else if (tally.counted > 0) {
    progress.status = ExerciseStatus::practised;
  } else if (progress.started > 0) {
    progress.status = ExerciseStatus::in_progress;
  } else {
    progress.status = ExerciseStatus::available;
  }
  progress.sentence = sentence_of(progress.status, tally);
  return progress;
}

}  // namespace assessment
