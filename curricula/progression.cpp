#include "curricula/progression.h"

#include <algorithm>
#include <set>

namespace curricula {
namespace {

using assessment::ExerciseStatus;

std::string title_of(const Text& title, const std::string& id) {
  const auto english = title.find("en");
  return english == title.end() || english->second.empty() ? id : english->second;
}

std::span<const PastTrial> trials_of(std::span<const ExerciseHistory> histories,
                                     const std::string& id) {
  for (const ExerciseHistory& history : histories) {
    if (history.exercise_id == id) return history.trials;
  }
  return {};
}

std::string times(int count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

// Works through the curriculum for one person.
class Walk {
 public:
  Walk(const Curriculum& curriculum, std::span<const ExerciseHistory> histories,
       const std::string& today)
      : curriculum_(curriculum), histories_(histories), today_(today) {
    for (const Exercise& exercise : curriculum.exercises) {
      if (is_proficient(exercise)) proficient_.insert(exercise.id);
    }
  }

  Progression run() {
    Progression result;
    for (const Block& block : curriculum_.plan) {
      result.blocks.push_back(state_of(block));
      for (const std::string& id : block.exercises) {
        if (const Exercise* exercise = curriculum_.find(id)) {
          result.exercises.push_back(state_of(*exercise, &block, &result.blocks.back()));
        }
      }
    }
    for (const Exercise& exercise : curriculum_.exercises) {
      if (!result.find(exercise.id))
        result.exercises.push_back(state_of(exercise, nullptr, nullptr));
    }
    choose_next(result);
    return result;
  }

 private:
  assessment::Progress progress(const Exercise& exercise, bool unlocked) const {
    std::vector<assessment::TrialOutcome> outcomes;
    for (const PastTrial& trial : trials_of(histories_, exercise.id))
      outcomes.push_back(trial.outcome);
    if (exercise.proficiency)
      return assessment::progress_of(*exercise.proficiency, outcomes, unlocked);
    return practice_only(outcomes, unlocked);
  }

  // An exercise that nobody can become proficient in is there to be tried.
  static assessment::Progress practice_only(std::span<const assessment::TrialOutcome> outcomes,
                                            bool unlocked) {
    assessment::Progress progress;
    progress.started = static_cast<int>(outcomes.size());
    for (const assessment::TrialOutcome& outcome : outcomes) {
      if (!outcome.counts()) continue;
      ++progress.counted;
      if (outcome.outcome == assessment::Outcome::passed) ++progress.passes;
    }
    progress.status = !unlocked              ? ExerciseStatus::locked
                      : progress.counted > 0 ? ExerciseStatus::practised
                                             : ExerciseStatus::available;
    progress.sentence = "For practice: " + times(progress.counted, "trial") + " so far";
    return progress;
  }

  // Proficiency is a matter of the trials alone: what was reached stays, whatever is locked later.
  bool is_proficient(const Exercise& exercise) const {
    const ExerciseStatus status = progress(exercise, true).status;
    return status == ExerciseStatus::proficient || status == ExerciseStatus::waived;
  }

  const Block* find_block(const std::string& id) const {
    for (const Block& block : curriculum_.plan) {
      if (block.id == id) return &block;
    }
    return nullptr;
  }

  bool all_proficient(const Block& block) const {
    return std::all_of(block.exercises.begin(), block.exercises.end(),
                       [&](const std::string& id) { return proficient_.contains(id); });
  }

  BlockState state_of(const Block& block) const {
    BlockState state;
    state.block_id = block.id;
    state.max_trials_per_day = block.max_trials_per_day;
    state.proficient = all_proficient(block);
    const Block* before = block.after.empty() ? nullptr : find_block(block.after);
    state.unlocked = !before || all_proficient(*before);
    for (const std::string& id : block.exercises) {
      for (const PastTrial& trial : trials_of(histories_, id)) {
        // begun is begun, passed or not; only what was voided never was
        if (!trial.outcome.voided && trial.date == today_) ++state.trials_today;
      }
    }
    return state;
  }

  // The first thing that keeps the exercise locked, as a sentence; empty when nothing does.
  std::string lock(const Exercise& exercise, const Block* block,
                   const BlockState* block_state) const {
    if (block_state && !block_state->unlocked) {
      const Block* before = find_block(block->after);
      return "First become proficient in the block \"" + title_of(before->title, before->id) +
             "\".";
    }
    std::vector<std::string> needed = exercise.requires_proficient;
    if (block && !block->any_order) {
      const auto here = std::find(block->exercises.begin(), block->exercises.end(), exercise.id);
      needed.insert(needed.end(), block->exercises.begin(), here);
    }
    for (const std::string& id : needed) {
      if (proficient_.contains(id)) continue;
      const Exercise* required = curriculum_.find(id);
      return "First become proficient in \"" + (required ? title_of(required->title, id) : id) +
             "\".";
    }
    return {};
  }

  ExerciseState state_of(const Exercise& exercise, const Block* block,
                         const BlockState* block_state) const {
    ExerciseState state;
    state.exercise_id = exercise.id;
    if (block) state.block_id = block->id;
    const std::string locked = lock(exercise, block, block_state);
    state.progress = progress(exercise, locked.empty());
    if (curriculum_.status == Lifecycle::draft) {
      state.why_not = "This curriculum is a draft: publish it first.";
    } else if (curriculum_.status == Lifecycle::retired) {
      state.why_not = "This curriculum is retired: use its successor.";
    } else if (!locked.empty()) {
      state.why_not = locked;
    } else if (state.progress.status == ExerciseStatus::exhausted) {
      state.why_not = "All " + times(exercise.proficiency->max_trials, "trial") +
                      " of this exercise are used: speak with your instructor.";
    } else if (block_state && block_state->max_trials_per_day > 0 &&
               block_state->trials_today >= block_state->max_trials_per_day) {
      state.why_not = "That was enough for today (" +
                      times(block_state->max_trials_per_day, "trial") + " a day): go on tomorrow.";
    }
    state.may_start = state.why_not.empty();
    return state;
  }

  // What was begun comes before what is new; both in the plan's order.
  void choose_next(Progression& result) const {
    const auto open = [&](const ExerciseState& state, bool begun) {
      const Exercise* exercise = curriculum_.find(state.exercise_id);
      return state.may_start && exercise->proficiency && !proficient_.contains(state.exercise_id) &&
             (state.progress.counted > 0) == begun;
    };
    for (const bool begun : {true, false}) {
      for (const ExerciseState& state : result.exercises) {
        if (!result.next.empty() || !open(state, begun)) continue;
        result.next = state.exercise_id;
        result.sentence =
            "Next: " + title_of(curriculum_.find(state.exercise_id)->title, state.exercise_id) +
            " (" + state.progress.sentence + ").";
      }
    }
    if (!result.next.empty()) return;
    for (const ExerciseState& state : result.exercises) {
      const bool wanted = !proficient_.contains(state.exercise_id) &&
                          curriculum_.find(state.exercise_id)->proficiency.has_value();
      if (wanted && result.sentence.empty()) result.sentence = state.why_not;
    }
    if (result.sentence.empty())
      result.sentence = "You are proficient in every exercise of this curriculum.";
  }

  const Curriculum& curriculum_;
  std::span<const ExerciseHistory> histories_;
  const std::string& today_;
  std::set<std::string> proficient_;
};

}  // namespace

const ExerciseState* Progression::find(const std::string& exercise_id) const {
  for (const ExerciseState& state : exercises) {
    if (state.exercise_id == exercise_id) return &state;
  }
  return nullptr;
}

const BlockState* Progression::find_block(const std::string& block_id) const {
  for (const BlockState& state : blocks) {
    if (state.block_id == block_id) return &state;
  }
  return nullptr;
}

Progression progression_of(const Curriculum& curriculum, std::span<const ExerciseHistory> histories,
                           const std::string& today) {
  return Walk(curriculum, histories, today).run();
}

base::Status may_start(const Curriculum& curriculum, std::span<const ExerciseHistory> histories,
                       const std::string& today, const std::string& exercise_id) {
  const Progression progression = progression_of(curriculum, histories, today);
  const ExerciseState* state = progression.find(exercise_id);
  if (!state) {
    return base::Error{base::ErrorCode::not_found,
                       "There is no exercise \"" + exercise_id +
                           "\" in this curriculum: choose one from My training."};
  }
  if (!state->may_start) return base::Error{base::ErrorCode::denied, state->why_not};
  return base::Done{};
}

}  // namespace curricula
