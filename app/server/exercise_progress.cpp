#include "app/server/exercise_progress.h"

#include <algorithm>

#include "app/server/views/briefing_view.h"
#include "app/server/views/words.h"
#include "assessment/metrics.h"

namespace app {
namespace {

using Trials = std::vector<const database::StoredTrial*>;

constexpr const char* kTime = "time_s";
constexpr const char* kForce = "force_max_n";

bool is_live(const database::StoredTrial& trial) {
  return trial.head.source == assessment::Source::live;
}

bool is_published(const database::StoredTrial& trial) {
  return trial.head.source == assessment::Source::published_data;
}

// Published trials were made on another apparatus, where neither our target nor our experts count;
// simulated operators are not shown beside people.
void add_references(reports::ProgressChart& chart, const curricula::Exercise& exercise,
                    const Trials& trials, const std::string& metric, const ExpertBands& bands) {
  const assessment::Rule* target = bound_of(exercise, metric);
  if (target != nullptr && std::none_of(trials.begin(), trials.end(),
                                        [](const auto* trial) { return is_published(*trial); })) {
    chart.target = target->bound;
    chart.target_provisional = target->provisional;
  }
  const auto band = bands.find({exercise.id, metric});
  if (band != bands.end() && std::all_of(trials.begin(), trials.end(),
                                         [](const auto* trial) { return is_live(*trial); })) {
    chart.expert_low = band->second.low;
    chart.expert_median = band->second.median;
    chart.expert_high = band->second.high;
  }
}

// One metric of each completed trial.
reports::ProgressChart metric_chart(const curricula::Exercise& exercise, const Trials& trials,
                                    const std::string& who, const std::string& metric,
                                    const ExpertBands& bands) {
  reports::ProgressChart chart;
  chart.unit = subject_unit(metric);
  chart.who = who;
  if (const auto* definition = assessment::find_metric(metric)) {
    chart.direction = definition->direction;
  }
  for (const database::StoredTrial* trial : trials) {
    chart.last_ordinal = std::max(chart.last_ordinal, trial->ordinal);
    if (trial->end_reason != assessment::EndReason::completed) {
      ++chart.unfinished;
      continue;
    }
    const auto value = metric_value(*trial, metric);
    if (!value) continue;
    chart.points.push_back(
        {trial->ordinal, *value, trial->outcome == assessment::Outcome::passed, counts(*trial)});
  }
  add_references(chart, exercise, trials, metric, bands);
  return chart;
}

ExerciseProgress progress_in(const curricula::Exercise& exercise,
                             const curricula::ExerciseState& state, Trials trials,
                             const std::string& who, bool you, const ExpertBands& bands) {
  ExerciseProgress progress;
  progress.exercise = &exercise;
  progress.state = &state;
  progress.trials = std::move(trials);
  progress.times = time_chart(exercise, progress.trials, who, bands);
  progress.forces = metric_chart(exercise, progress.trials, who, kForce, bands);
  progress.forces.id = exercise.id + "-" + kForce;
  progress.forces.title = subject_title(kForce) + " per trial";
  progress.headline = reports::progress_headline(english(exercise.title), progress.times,
                                                 state.progress.sentence, you);
  for (const std::string& metric : exercise.record) {
    MetricProgress one{metric, metric_chart(exercise, progress.trials, who, metric, bands)};
    one.chart.id = exercise.id + "-small-" + metric;
    one.chart.title = subject_title(metric) + (one.chart.unit.empty() ? "" : ", " + one.chart.unit);
    progress.metrics.push_back(std::move(one));
  }
  return progress;
}

}  // namespace

std::vector<ExerciseProgress> exercises_progress(const TrainingRecord& record,
                                                 const std::string& who, bool you,
                                                 const ExpertBands& bands) {
  std::vector<ExerciseProgress> all;
  for (const curricula::ExerciseState& state : record.progression.exercises) {
    const curricula::Exercise* exercise = record.curriculum->find(state.exercise_id);
    if (exercise == nullptr) continue;
    all.push_back(progress_in(*exercise, state, record.trials_of(exercise->id), who, you, bands));
  }
  return all;
}

std::vector<reports::Chart> large_charts(const ExerciseProgress& progress) {
  std::vector<reports::Chart> charts = {reports::progress_chart(progress.times)};
  if (!progress.forces.points.empty()) charts.push_back(reports::progress_chart(progress.forces));
  return charts;
}

reports::ProgressChart time_chart(const curricula::Exercise& exercise, const Trials& trials,
                                  const std::string& who, const ExpertBands& bands) {
  reports::ProgressChart chart = metric_chart(exercise, trials, who, kTime, bands);
  chart.id = exercise.id + "-time";
  chart.title = "Time per trial";
  return chart;
}

bool counts(const database::StoredTrial& trial) {
  return trial.voided_utc.empty() && !trial.interrupted;
}

}  // namespace app
