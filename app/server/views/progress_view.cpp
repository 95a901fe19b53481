#include "app/server/views/progress_view.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "app/server/exercise_progress.h"
#include "app/server/views/briefing_view.h"
#include "app/server/views/json_views.h"
#include "app/server/views/trial_view.h"
#include "app/server/views/words.h"
#include "database/trial_summaries.h"
#include "reports/standing.h"

namespace app {
namespace {

using nlohmann::json;
using Trials = std::vector<const database::StoredTrial*>;

constexpr std::size_t kLastTrials = 3;

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
                             const curricula::Library& library, const ExpertBands& bands) {
  const curricula::Exercise* exercise = record.curriculum->find(record.progression.next);
  const curricula::ExerciseState* state = record.progression.find(record.progression.next);
  if (exercise == nullptr || state == nullptr) return json(nullptr);

  const Trials all = record.trials_of(exercise->id);
  const Trials last(all.end() - static_cast<std::ptrdiff_t>(std::min(all.size(), kLastTrials)),
                    all.end());
  std::map<std::string, int> errors;
  if (!all.empty()) {
    auto found = database::critical_errors(store, all.front()->head.person_id);
    if (!found) return found.error();
    errors = *std::move(found);
  }
  const reports::ProgressChart chart = time_chart(*exercise, all, "You", bands);
  const bool drawn = !chart.points.empty();
  return json{{"briefing", briefing_json(*record.curriculum, *exercise, *state, library)},
              {"headline", reports::progress_headline(english(exercise->title), chart,
                                                      state->progress.sentence, true)},
              {"ordinal", all.empty() ? 1 : all.back()->ordinal + 1},
              {"last_trials", trial_rows_json(last, exercise, errors)},
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

json standing_json(const reports::ProgressChart& chart, const std::string& metric) {
  const reports::Standing standing = reports::standing_of(chart);
  const bool lower = chart.direction == assessment::Direction::lower_is_better;
  return {{"metric", metric},
          {"title", subject_title(metric)},
          {"unit", chart.unit},
          {"direction", lower ? "lower" : "higher"},
          {"last", number_or_null(standing.last)},
          {"previous", number_or_null(standing.previous)},
          {"best", number_or_null(standing.best)},
          {"change_to_previous_percent", number_or_null(standing.change_to_previous_percent)},
          {"change_to_first_percent", number_or_null(standing.change_to_first_percent)}};
}

json exercise_progress_json(const ExerciseProgress& progress,
                            const std::map<std::string, int>& critical_errors) {
  json small = json::array(), standings = json::array();
  for (const MetricProgress& metric : progress.metrics) {
    small.push_back(to_json(reports::small_progress_chart(metric.chart)));
    standings.push_back(standing_json(metric.chart, metric.metric));
  }
  return {{"exercise_id", progress.exercise->id},
          {"title", english(progress.exercise->title)},
          {"status", assessment::word(progress.state->progress.status)},
          {"headline", progress.headline},
          {"charts", to_json(large_charts(progress))},
          {"small_multiples", small},
          {"standings", standings},
          {"trials", trial_rows_json(progress.trials, progress.exercise, critical_errors)}};
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
                                 const curricula::Library& library, const ExpertBands& bands) {
  auto next = next_json(store, record, library, bands);
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
                                           const database::Person& person, bool you,
                                           const ExpertBands& bands) {
  const auto errors = database::critical_errors(store, person.id);
  if (!errors) return errors.error();
  json exercises = json::array();
  for (const ExerciseProgress& progress :
       exercises_progress(record, you ? "You" : person.display_name, you, bands)) {
    exercises.push_back(exercise_progress_json(progress, *errors));
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
