#include "app/server/views/progress_view.h"

#include <algorithm>
#include <vector>

#include "app/server/views/briefing_view.h"
#include "app/server/views/json_views.h"
#include "app/server/views/trial_view.h"
#include "app/server/views/words.h"

namespace app {
namespace {

using nlohmann::json;
using Trials = std::vector<const database::StoredTrial*>;

constexpr std::size_t kLastTrials = 3;

bool counts(const database::StoredTrial& trial) {
  return trial.voided_utc.empty() && !trial.interrupted;
}

// The time of each finished trial against the target of the exercise.
reports::ProgressChart time_chart(const curricula::Exercise& exercise, const Trials& trials,
                                  const std::string& who) {
  reports::ProgressChart chart;
  chart.id = exercise.id + "-time";
  chart.title = "Time per trial";
  chart.unit = "s";
  chart.who = who;
  bool published = false;
  for (const database::StoredTrial* trial : trials) {
    published = published || trial->head.source == assessment::Source::published_data;
    const auto time = metric_value(*trial, "time_s");
    if (!time || trial->end_reason != assessment::EndReason::completed) continue;
    chart.points.push_back(
        {trial->ordinal, *time, trial->outcome == assessment::Outcome::passed, counts(*trial)});
  }
  const assessment::Rule* target = target_of(exercise, "time_s");
  if (target != nullptr && !published) {
    chart.target = target->bound;
    chart.target_provisional = target->provisional;
  }
  return chart;
}

// The same for another metric, without a target line unless the rule has one.
reports::ProgressChart metric_chart(const curricula::Exercise& exercise, const Trials& trials,
                                    const std::string& who, const std::string& metric) {
  reports::ProgressChart chart;
  chart.id = exercise.id + "-" + metric;
  chart.title = subject_title(metric) + " per trial";
  chart.unit = subject_unit(metric);
  chart.who = who;
  for (const database::StoredTrial* trial : trials) {
    const auto value = metric_value(*trial, metric);
    if (!value || trial->end_reason != assessment::EndReason::completed) continue;
    chart.points.push_back(
        {trial->ordinal, *value, trial->outcome == assessment::Outcome::passed, counts(*trial)});
  }
  if (const assessment::Rule* target = target_of(exercise, metric)) {
    chart.target = target->bound;
    chart.target_provisional = target->provisional;
  }
  return chart;
}

json blocks_json(const TrainingRecord& record) {
  json blocks = json::array();
  for (const curricula::Block& block : record.curriculum->plan) {
    json cards = json::array();
    for (const std::string& id : block.exercises) {
      const curricula::Exercise* exercise = record.curriculum->find(id);
      const curricula::ExerciseState* state = record.progression.find(id);
      if (exercise != nullptr && state != nullptr) {
        cards.push_back(exercise_card_json(*exercise, *state));
      }
    }
    blocks.push_back({{"id", block.id},
                      {"title", capitalised(block.id)},
                      {"any_order", block.any_order},
                      {"after", capitalised(block.after)},
                      {"exercises", cards}});
  }
  return blocks;
}

base::Result<json> next_json(database::Store& store, const TrainingRecord& record,
                             const curricula::Library& library) {
  const curricula::Exercise* exercise = record.curriculum->find(record.progression.next);
  const curricula::ExerciseState* state = record.progression.find(record.progression.next);
  if (exercise == nullptr || state == nullptr) return json(nullptr);

  const Trials all = record.trials_of(exercise->id);
  const Trials last(all.end() - static_cast<std::ptrdiff_t>(std::min(all.size(), kLastTrials)),
                    all.end());
  auto rows = trial_rows_json(store, last, exercise);
  if (!rows) return rows.error();
  const reports::ProgressChart chart = time_chart(*exercise, all, "You");
  const bool drawn = !chart.points.empty();
  return json{{"briefing", briefing_json(*record.curriculum, *exercise, *state, library)},
              {"headline", reports::progress_headline(english(exercise->title), chart,
                                                      state->progress.sentence, true)},
              {"ordinal", all.empty() ? 1 : all.back()->ordinal + 1},
              {"last_trials", *std::move(rows)},
              {"chart", drawn ? to_json(reports::progress_chart(chart)) : json(nullptr)}};
}

// The block whose daily maximum matters now: that of the next exercise, or the first with one.
const curricula::BlockState* limiting_block(const curricula::Progression& progression) {
  const curricula::ExerciseState* next = progression.find(progression.next);
  if (next != nullptr) return progression.find_block(next->block_id);
  const auto limited =
      std::find_if(progression.blocks.begin(), progression.blocks.end(),
                   [](const curricula::BlockState& block) { return block.max_trials_per_day > 0; });
  return limited == progression.blocks.end() ? nullptr : &*limited;
}

base::Result<json> exercise_progress_json(database::Store& store, const TrainingRecord& record,
                                          const curricula::Exercise& exercise,
                                          const curricula::ExerciseState& state,
                                          const std::string& who, bool you) {
  const Trials trials = record.trials_of(exercise.id);
  auto rows = trial_rows_json(store, trials, &exercise);
  if (!rows) return rows.error();
  const reports::ProgressChart times = time_chart(exercise, trials, who);
  json charts = json::array();
  charts.push_back(to_json(reports::progress_chart(times)));
  const reports::ProgressChart forces = metric_chart(exercise, trials, who, "force_max_n");
  if (!forces.points.empty()) charts.push_back(to_json(reports::progress_chart(forces)));
  return json{{"exercise_id", exercise.id},
              {"title", english(exercise.title)},
              {"status", assessment::word(state.progress.status)},
              {"headline", reports::progress_headline(english(exercise.title), times,
                                                      state.progress.sentence, you)},
              {"charts", charts},
              {"trials", *std::move(rows)}};
}

}  // namespace

json exercise_card_json(const curricula::Exercise& exercise,
                        const curricula::ExerciseState& state) {
  const bool locked = state.progress.status == assessment::ExerciseStatus::locked;
  return {{"exercise_id", exercise.id},
          {"title", english(exercise.title)},
          {"status", assessment::word(state.progress.status)},
          {"sentence", locked ? state.why_not : state.progress.sentence}};
}

base::Result<json> training_json(database::Store& store, const TrainingRecord& record,
                                 const curricula::Library& library) {
  auto next = next_json(store, record, library);
  if (!next) return next.error();
  const auto& states = record.progression.exercises;
  const auto proficient = std::count_if(states.begin(), states.end(), [](const auto& state) {
    return state.progress.status == assessment::ExerciseStatus::proficient;
  });
  const curricula::BlockState* block = limiting_block(record.progression);
  return json{{"curriculum_title", english(record.curriculum->title)},
              {"curriculum_version", record.curriculum->version},
              {"proficient_count", proficient},
              {"exercise_count", states.size()},
              {"max_trials_per_day", block == nullptr ? 0 : block->max_trials_per_day},
              {"trials_today", block == nullptr ? 0 : block->trials_today},
              {"blocks", blocks_json(record)},
              {"next", *std::move(next)}};
}

base::Result<json> exercises_progress_json(database::Store& store, const TrainingRecord& record,
                                           const database::Person& person, bool you) {
  json exercises = json::array();
  for (const curricula::ExerciseState& state : record.progression.exercises) {
    const curricula::Exercise* exercise = record.curriculum->find(state.exercise_id);
    if (exercise == nullptr) continue;
    auto progress = exercise_progress_json(store, record, *exercise, state,
                                           you ? "You" : person.display_name, you);
    if (!progress) return progress.error();
    exercises.push_back(*std::move(progress));
  }
  return exercises;
}

json person_row_json(const database::Person& person, const TrainingRecord& record) {
  std::string last;
  for (const database::StoredTrial& trial : record.trials) {
    last = std::max(last, trial.head.started_utc);
  }
  json statuses = json::array();
  // published trials were made elsewhere: they move nobody through this plan
  if (person.kind != database::PersonKind::published) {
    for (const curricula::ExerciseState& state : record.progression.exercises) {
      const curricula::Exercise* exercise = record.curriculum->find(state.exercise_id);
      if (exercise != nullptr) statuses.push_back(exercise_card_json(*exercise, state));
    }
  }
  return {{"person_id", person.id},
          {"display_name", person.display_name},
          {"name", person.name},
          {"role", database::word(person.role)},
          {"kind", database::word(person.kind)},
          {"level", person.level ? json(database::word(*person.level)) : json(nullptr)},
          {"groups", person.groups},
          {"disabled", person.disabled},
          {"trials", record.trials.size()},
          {"last_trial_utc", last.empty() ? json(nullptr) : json(last)},
          {"statuses", statuses}};
}

}  // namespace app
