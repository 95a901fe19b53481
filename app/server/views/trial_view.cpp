#include "app/server/views/trial_view.h"

#include <algorithm>

#include "app/server/training_record.h"
#include "app/server/views/briefing_view.h"
#include "app/server/views/json_views.h"
#include "app/server/views/words.h"
#include "app/session/trial_file.h"
#include "assessment/metrics.h"
#include "assessment/rule.h"
#include "reports/trial_charts.h"
#include "sim/base/units.h"

namespace app {
namespace {

using namespace base::units;
using nlohmann::json;

bool is_published(const database::StoredTrial& trial) {
  return trial.head.source == assessment::Source::published_data;
}

json criterion_json(const assessment::Criterion& criterion) {
  return {{"subject", criterion.subject},
          {"title", subject_title(criterion.subject)},
          {"op", assessment::sign(criterion.comparison)},
          {"needed", criterion.bound},
          {"value", number_or_null(criterion.value)},
          {"unit", subject_unit(criterion.subject)},
          {"met", criterion.met},
          {"provisional", criterion.provisional},
          {"note", criterion.value ? "" : "This trial has no such value."}};
}

json events_json(const std::vector<assessment::Event>& events,
                 const std::vector<curricula::Step>& steps) {
  json list = json::array();
  for (const assessment::Event& event : events) {
    list.push_back({{"time_s", event.time},
                    {"code", event.code},
                    {"severity", assessment::word(event.severity)},
                    {"text", event_text(event, steps)}});
  }
  return list;
}

int critical_count(const std::vector<assessment::Event>& events) {
  return static_cast<int>(
      std::count_if(events.begin(), events.end(), [](const assessment::Event& event) {
        return event.severity == assessment::Severity::critical;
      }));
}

// The bound that ends or marks the trial by its contact force, if the exercise has one.
std::optional<double> force_limit(const curricula::Exercise* exercise) {
  if (exercise == nullptr) return std::nullopt;
  for (const curricula::Limit& limit : exercise->limits) {
    if (limit.metric == "force_max_n") return limit.bound;
  }
  return std::nullopt;
}

// Time per step, and contact force over time; nothing for a trial without a trace.
base::Result<json> charts_json(database::Store& store, const database::StoredTrial& trial,
                               const curricula::Exercise* exercise,
                               const std::vector<curricula::Step>& steps) {
  json charts = json::array();
  if (is_published(trial)) return charts;
  auto recorded = load_recorded(store, trial.head.id);
  if (!recorded) return recorded.error();
  if (recorded->samples.empty()) return charts;
  std::vector<reports::StepDuration> durations;
  for (const assessment::StepTime& time : assessment::step_times(*recorded)) {
    durations.push_back({step_title(time.step_id, steps), time.seconds});
  }
  if (!durations.empty()) charts.push_back(to_json(reports::step_time_chart(durations)));
  assessment::RecordedTrial drawn = *std::move(recorded);
  for (assessment::TrialStep& step : drawn.steps) step.id = step_title(step.id, steps);
  charts.push_back(to_json(reports::contact_force_chart(drawn, force_limit(exercise))));
  return charts;
}

// The stored verdict; for a trial that was never judged, one that says so.
base::Result<assessment::Verdict> verdict_of(database::Store& store,
                                             const database::StoredTrial& trial) {
  auto verdict = database::trial_verdict(store, trial.head.id);
  if (verdict || verdict.error().code != base::ErrorCode::not_found) return verdict;
  assessment::Verdict none;
  none.sentence = is_published(trial)
                      ? "Published data: made on another apparatus, so not judged here."
                      : "This trial was cut off before it could be judged.";
  return none;
}

}  // namespace

json criteria_json(const std::vector<assessment::Criterion>& criteria) {
  json list = json::array();
  for (const assessment::Criterion& criterion : criteria) list.push_back(criterion_json(criterion));
  return list;
}

json metrics_json(const std::vector<assessment::MetricValue>& metrics) {
  json list = json::array();
  for (const assessment::MetricDefinition& metric : assessment::metric_definitions()) {
    const auto value = std::find_if(metrics.begin(), metrics.end(),
                                    [&](const auto& each) { return each.id == metric.id; });
    if (value == metrics.end()) continue;
    const bool lower = metric.direction == assessment::Direction::lower_is_better;
    list.push_back({{"id", metric.id},
                    {"version", metric.version},
                    {"title", metric.title},
                    {"value", value->value},
                    {"unit", metric.unit},
                    {"direction", lower ? "lower" : "higher"},
                    {"definition", metric.definition}});
  }
  return list;
}

json trial_row_json(const database::StoredTrial& trial, const curricula::Exercise* exercise,
                    int critical_errors) {
  const assessment::Rule* target =
      exercise == nullptr || is_published(trial) ? nullptr : target_of(*exercise, "time_s");
  return {
      {"trial_id", trial.head.id},
      {"exercise_id", trial.head.exercise_id},
      {"ordinal", trial.ordinal},
      {"started_utc", trial.head.started_utc},
      {"end_reason", trial.end_reason ? json(assessment::word(*trial.end_reason)) : json(nullptr)},
      {"source", assessment::word(trial.head.source)},
      {"device", trial.head.device},
      {"outcome", trial.outcome ? json(assessment::word(*trial.outcome)) : json(nullptr)},
      {"time_s", number_or_null(metric_value(trial, "time_s"))},
      {"target_s", target == nullptr ? json(nullptr) : json(target->bound)},
      {"force_max_n", number_or_null(metric_value(trial, "force_max_n"))},
      {"critical_errors", critical_errors},
      {"voided", !trial.voided_utc.empty()},
      {"interrupted", trial.interrupted}};
}

json trial_rows_json(const std::vector<const database::StoredTrial*>& trials,
                     const curricula::Exercise* exercise,
                     const std::map<std::string, int>& critical_errors) {
  json rows = json::array();
  for (auto trial = trials.rbegin(); trial != trials.rend(); ++trial) {
    const auto errors = critical_errors.find((*trial)->head.id);
    rows.push_back(
        trial_row_json(**trial, exercise, errors == critical_errors.end() ? 0 : errors->second));
  }
  return rows;
}

base::Result<json> debrief_json(database::Store& store, const database::StoredTrial& trial,
                                const curricula::Exercise* exercise) {
  std::vector<curricula::Step> steps;
  if (exercise != nullptr) steps = curricula::unroll(exercise->steps);
  const auto verdict = verdict_of(store, trial);
  if (!verdict) return verdict.error();
  const auto events = database::trial_events(store, trial.head.id);
  if (!events) return events.error();
  auto charts = charts_json(store, trial, exercise, steps);
  if (!charts) return charts.error();

  const bool judged = exercise != nullptr && exercise->pass.has_value() && !is_published(trial);
  return json{{"trial", trial_row_json(trial, exercise, critical_count(*events))},
              {"person_name", trial.person_name},
              {"exercise_title", exercise == nullptr ? capitalised(trial.head.exercise_id)
                                                     : english(exercise->title)},
              {"exercise_version", exercise == nullptr ? 1 : exercise->version},
              {"rule_sentence", judged ? rule_sentence(*exercise->pass) : "Not judged by a rule."},
              {"verdict_sentence", verdict->sentence},
              {"criteria", criteria_json(verdict->criteria)},
              {"metrics", metrics_json(trial.metrics)},
              {"events", events_json(*events, steps)},
              {"charts", *std::move(charts)},
              {"build", trial.head.build},
              {"state_hash", trial.state_hash},
              {"paused_s", trial.paused_s},
              {"slowed_s", trial.slowed_s}};
}

}  // namespace app
