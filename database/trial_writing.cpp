#include <cmath>

#include "database/text_limits.h"
#include "database/trial_rows.h"
#include "database/utc.h"

namespace database {
namespace {

using assessment::word;
using base::Error;
using base::ErrorCode;

base::Status check_head(const NewTrial& trial) {
  if (base::Status status = check_name("id of the trial", trial.id); !status) return status;
  if (base::Status status = check_name("id of the exercise", trial.exercise_id); !status) {
    return status;
  }
  for (const std::string* text : {&trial.dataset, &trial.apparatus, &trial.device, &trial.build,
                                  &trial.isa, &trial.anatomy_sha256, &trial.instruments_sha256}) {
    if (base::Status status = check_text("description of the trial", *text); !status) {
      return status;
    }
  }
  return base::Done{};
}

base::Status check_chunks(std::span<const Chunk> chunks) {
  for (const Chunk& chunk : chunks) {
    if (base::Status status = check_name("codec of the chunk", chunk.codec); !status) {
      return status;
    }
  }
  return base::Done{};
}

base::Status check_events(std::span<const assessment::Event> events) {
  for (const assessment::Event& event : events) {
    if (base::Status status = check_name("code of the event", event.code); !status) return status;
    if (base::Status status = check_text("detail of the event", event.detail); !status) {
      return status;
    }
  }
  return base::Done{};
}

base::Status check_metrics(std::span<const assessment::MetricValue> metrics) {
  for (const assessment::MetricValue& metric : metrics) {
    if (base::Status status = check_name("id of the metric", metric.id); !status) return status;
    if (!std::isfinite(metric.value)) {
      return Error{ErrorCode::invalid_input,
                   "The metric " + metric.id + " of the trial is not a number."};
    }
  }
  return base::Done{};
}

base::Status check_verdict(const FinishedTrial& finished) {
  if (base::Status status = check_text("version of the rule", finished.rule_version); !status) {
    return status;
  }
  return check_text("sentence of the verdict", finished.verdict.sentence);
}

base::Status check_references(soci::session& sql, const NewTrial& trial) {
  const auto exists = [&](const char* query, const std::string& id) {
    int count = 0;
    sql << query, soci::use(id), soci::into(count);
    return count > 0;
  };
  if (!exists("SELECT count(*) FROM person WHERE id = :id", trial.person_id)) {
    return Error{ErrorCode::not_found, "There is no such person."};
  }
  if (!trial.exercise_version_id.empty() &&
      !exists("SELECT count(*) FROM exercise_version WHERE id = :id", trial.exercise_version_id)) {
    return Error{ErrorCode::not_found, "There is no such version of an exercise."};
  }
  if (exists("SELECT count(*) FROM trial WHERE id = :id", trial.id)) {
    return Error{ErrorCode::conflict, "There is already a trial with this id."};
  }
  return base::Done{};
}

int next_ordinal(soci::session& sql, const NewTrial& trial) {
  int ordinal = 0;
  sql << "SELECT coalesce(max(ordinal), 0) + 1 FROM trial "
         "WHERE person_id = :person AND exercise_id = :exercise",
      soci::use(trial.person_id), soci::use(trial.exercise_id), soci::into(ordinal);
  return ordinal;
}

base::Result<int> insert_trial(soci::session& sql, const NewTrial& trial,
                               const std::string& started_utc) {
  if (base::Status status = check_references(sql, trial); !status) return status.error();
  const int ordinal = next_ordinal(sql, trial);
  execute(sql,
          "INSERT INTO trial (id, person_id, enrolment_id, exercise_id, exercise_version_id, "
          "ordinal, source, dataset, apparatus, device, seed, build, isa, anatomy_sha256, "
          "instruments_sha256, input_sha256, state_hash, started_utc, end_time_s, paused_s, "
          "slowed_s, interrupted) VALUES (:id, :person, nullif(:enrolment, ''), :exercise, "
          "nullif(:version, ''), :ordinal, "
          ":source, :dataset, :apparatus, :device, :seed, :build, :isa, :anatomy, :instruments, "
          "'', '', :started, 0.0, 0.0, 0.0, 0)",
          trial.id, trial.person_id, trial.enrolment_id, trial.exercise_id,
          trial.exercise_version_id, ordinal, std::string(word(trial.source)), trial.dataset,
          trial.apparatus, trial.device, std::to_string(trial.seed), trial.build, trial.isa,
          trial.anatomy_sha256, trial.instruments_sha256, started_utc);
  return ordinal;
}

void end_trial(soci::session& sql, const std::string& trial_id, const FinishedTrial& finished,
               const std::string& ended_utc) {
  execute(sql,
          "UPDATE trial SET ended_utc = :ended, end_reason = :reason, end_time_s = :end_time, "
          "paused_s = :paused, slowed_s = :slowed, interrupted = :interrupted, "
          "input_sha256 = :input, state_hash = :state WHERE id = :id",
          ended_utc, std::string(word(finished.end_reason)), finished.end_time_s, finished.paused_s,
          finished.slowed_s, finished.interrupted ? 1 : 0, finished.input_sha256,
          finished.state_hash, trial_id);
}

void insert_criteria(soci::session& sql, const std::string& trial_id, int score_ordinal,
                     const std::vector<assessment::Criterion>& criteria) {
  int position = 0;
  for (const assessment::Criterion& criterion : criteria) {
    execute(sql,
            "INSERT INTO criterion (trial_id, score_ordinal, position, subject, comparison, bound, "
            "value, met, benchmark, provisional) VALUES (:trial, :score, :position, :subject, "
            ":comparison, :bound, CASE WHEN :has_value = 1 THEN :value END, :met, :benchmark, "
            ":provisional)",
            trial_id, score_ordinal, position, criterion.subject,
            std::string(sign(criterion.comparison)), criterion.bound, criterion.value ? 1 : 0,
            criterion.value.value_or(0.0), criterion.met ? 1 : 0, criterion.benchmark,
            criterion.provisional ? 1 : 0);
    ++position;
  }
}

}  // namespace

void insert_events(soci::session& sql, const std::string& trial_id,
                   std::span<const assessment::Event> events) {
  if (events.empty()) return;
  int seq = 0;
  sql << "SELECT coalesce(max(seq), -1) + 1 FROM event WHERE trial_id = :id", soci::use(trial_id),
      soci::into(seq);
  for (const assessment::Event& event : events) {
    execute(sql,
            "INSERT INTO event (trial_id, seq, t_s, code, severity, detail, value) VALUES "
            "(:trial, :seq, :t, :code, :severity, :detail, CASE WHEN :known = 1 THEN :value END)",
            trial_id, seq, event.time, event.code, std::string(word(event.severity)), event.detail,
            std::isnan(event.value) ? 0 : 1, event.value);
    ++seq;
  }
}

void insert_steps(soci::session& sql, const std::string& trial_id,
                  std::span<const assessment::TrialStep> steps) {
  int position = 0;
  for (const assessment::TrialStep& step : steps) {
    execute(sql,
            "INSERT INTO trial_step (trial_id, position, step_id, kind, target, tolerance, "
            "started_s, ended_s, residual) VALUES (:trial, :position, :step, :kind, :target, "
            ":tolerance, :started, CASE WHEN :done = 1 THEN :ended END, :residual)",
            trial_id, position, step.id, std::string(word(step.kind)), step.target, step.tolerance,
            step.started, step.done() ? 1 : 0, step.ended, step.residual);
    ++position;
  }
}

void insert_metrics(soci::session& sql, const std::string& trial_id,
                    std::span<const assessment::MetricValue> metrics) {
  if (metrics.empty()) return;
  int position = 0;
  assessment::MetricValue metric;
  soci::statement insert =
      (sql.prepare << "INSERT INTO metric_value (trial_id, position, metric, version, value) "
                      "VALUES (:trial, :position, :metric, :version, :value)",
       soci::use(trial_id), soci::use(position), soci::use(metric.id), soci::use(metric.version),
       soci::use(metric.value));
  for (const assessment::MetricValue& each : metrics) {
    metric = each;
    insert.execute(true);
    ++position;
  }
}

void insert_score(soci::session& sql, const std::string& trial_id, const std::string& rule_version,
                  const assessment::Verdict& verdict) {
  int ordinal = 0;
  sql << "SELECT coalesce(max(ordinal), 0) + 1 FROM score WHERE trial_id = :id",
      soci::use(trial_id), soci::into(ordinal);
  const std::string outcome = word(verdict.outcome);
  execute(sql,
          "INSERT INTO score (trial_id, ordinal, rule_version, outcome, sentence, scored_utc) "
          "VALUES (:trial, :ordinal, :rule, :outcome, :sentence, :utc)",
          trial_id, ordinal, rule_version, outcome, verdict.sentence, utc_now());
  insert_criteria(sql, trial_id, ordinal, verdict.criteria);
  execute(sql, "UPDATE trial SET outcome = :outcome WHERE id = :id", outcome, trial_id);
}

base::Result<int> begin_trial(Store& store, const NewTrial& trial) {
  if (base::Status status = check_head(trial); !status) return status.error();
  const base::Result<std::string> started = stored_utc(trial.started_utc);
  if (!started) return started.error();
  return writing(store, [&](soci::session& sql) { return insert_trial(sql, trial, *started); });
}

base::Status append_trace(Store& store, const std::string& trial_id, std::span<const Chunk> chunks,
                          std::span<const assessment::Event> events) {
  if (base::Status status = check_chunks(chunks); !status) return status;
  if (base::Status status = check_events(events); !status) return status;
  return writing(store, [&](soci::session& sql) -> base::Status {
    if (base::Status status = check_running(sql, trial_id); !status) return status;
    insert_chunks(store.connection(), trial_id, chunks);
    insert_events(sql, trial_id, events);
    return base::Done{};
  });
}

base::Status finish_trial(Store& store, const std::string& trial_id, const FinishedTrial& finished,
                          std::span<const Chunk> chunks,
                          std::span<const assessment::Event> events) {
  if (base::Status status = check_chunks(chunks); !status) return status;
  if (base::Status status = check_events(events); !status) return status;
  if (base::Status status = check_metrics(finished.metrics); !status) return status;
  if (base::Status status = check_verdict(finished); !status) return status;
  return writing(store, [&](soci::session& sql) -> base::Status {
    if (base::Status status = check_running(sql, trial_id); !status) return status;
    insert_chunks(store.connection(), trial_id, chunks);
    insert_events(sql, trial_id, events);
    insert_steps(sql, trial_id, finished.steps);
    insert_metrics(sql, trial_id, finished.metrics);
    insert_score(sql, trial_id, finished.rule_version, finished.verdict);
    end_trial(sql, trial_id, finished, utc_now());
    return base::Done{};
  });
}

base::Status import_trial(Store& store, const NewTrial& trial,
                          std::span<const assessment::MetricValue> metrics) {
  if (base::Status status = check_head(trial); !status) return status;
  if (base::Status status = check_metrics(metrics); !status) return status;
  const base::Result<std::string> started = stored_utc(trial.started_utc);
  if (!started) return started.error();
  FinishedTrial finished;
  finished.end_reason = assessment::EndReason::completed;
  for (const assessment::MetricValue& metric : metrics) {
    if (metric.id == "time_s") finished.end_time_s = metric.value;
  }
  return writing(store, [&](soci::session& sql) -> base::Status {
    if (const auto ordinal = insert_trial(sql, trial, *started); !ordinal) return ordinal.error();
    insert_metrics(sql, trial.id, metrics);
    end_trial(sql, trial.id, finished, *started);
    return base::Done{};
  });
}

}  // namespace database
