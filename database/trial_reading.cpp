#include <limits>
#include <utility>

#include "database/trial_rows.h"

namespace database {
namespace {

using base::Error;
using base::ErrorCode;

base::Result<std::vector<assessment::Criterion>> load_criteria(soci::session& sql,
                                                               const std::string& trial_id,
                                                               int score_ordinal) {
  std::vector<assessment::Criterion> criteria;
  assessment::Criterion criterion;
  std::string comparison;
  double value = 0.0;
  soci::indicator has_value = soci::i_ok;
  int met = 0, provisional = 0;
  soci::statement select =
      (sql.prepare << "SELECT subject, comparison, bound, value, met, benchmark, provisional "
                      "FROM criterion WHERE trial_id = :trial AND score_ordinal = :score "
                      "ORDER BY position",
       soci::use(trial_id), soci::use(score_ordinal), soci::into(criterion.subject),
       soci::into(comparison), soci::into(criterion.bound), soci::into(value, has_value),
       soci::into(met), soci::into(criterion.benchmark), soci::into(provisional));
  select.execute();
  while (select.fetch()) {
    if (!assessment::parse(comparison, criterion.comparison)) {
      return unknown_word("comparison", comparison);
    }
    criterion.value.reset();
    if (has_value == soci::i_ok) criterion.value = value;
    criterion.met = met != 0;
    criterion.provisional = provisional != 0;
    criteria.push_back(criterion);
  }
  return criteria;
}

base::Result<std::vector<assessment::Event>> load_events(soci::session& sql,
                                                         const std::string& trial_id) {
  std::vector<assessment::Event> events;
  assessment::Event event;
  std::string severity;
  soci::indicator has_value = soci::i_ok;
  soci::statement select =
      (sql.prepare << "SELECT t_s, code, severity, detail, value FROM event "
                      "WHERE trial_id = :id ORDER BY seq",
       soci::use(trial_id), soci::into(event.time), soci::into(event.code), soci::into(severity),
       soci::into(event.detail), soci::into(event.value, has_value));
  select.execute();
  while (select.fetch()) {
    if (!assessment::parse(severity, event.severity)) return unknown_word("severity", severity);
    if (has_value == soci::i_null) event.value = std::numeric_limits<double>::quiet_NaN();
    events.push_back(event);
  }
  return events;
}

base::Result<std::vector<assessment::TrialStep>> load_steps(soci::session& sql,
                                                            const std::string& trial_id) {
  std::vector<assessment::TrialStep> steps;
  assessment::TrialStep step;
  std::string kind;
  soci::indicator ended = soci::i_ok;
  soci::statement select =
      (sql.prepare << "SELECT step_id, kind, target, tolerance, started_s, ended_s, residual "
                      "FROM trial_step WHERE trial_id = :id ORDER BY position",
       soci::use(trial_id), soci::into(step.id), soci::into(kind), soci::into(step.target),
       soci::into(step.tolerance), soci::into(step.started), soci::into(step.ended, ended),
       soci::into(step.residual));
  select.execute();
  while (select.fetch()) {
    if (!assessment::parse(kind, step.kind)) return unknown_word("kind of step", kind);
    if (ended == soci::i_null) step.ended = assessment::TrialStep().ended;
    steps.push_back(step);
  }
  return steps;
}

base::Result<assessment::Verdict> load_verdict(soci::session& sql, const std::string& trial_id) {
  assessment::Verdict verdict;
  std::string outcome;
  int ordinal = 0;
  sql << "SELECT ordinal, outcome, sentence FROM score WHERE trial_id = :id "
         "ORDER BY ordinal DESC LIMIT 1",
      soci::use(trial_id), soci::into(ordinal), soci::into(outcome), soci::into(verdict.sentence);
  if (!sql.got_data()) {
    return Error{ErrorCode::not_found, "This trial has not been judged."};
  }
  if (!assessment::parse(outcome, verdict.outcome)) return unknown_word("outcome", outcome);
  auto criteria = load_criteria(sql, trial_id, ordinal);
  if (!criteria) return criteria.error();
  verdict.criteria = *std::move(criteria);
  return verdict;
}

}  // namespace

base::Error unknown_trial() { return {ErrorCode::not_found, "There is no such trial."}; }

base::Error unknown_word(const char* what, const std::string& text) {
  return {ErrorCode::corrupt_data, std::string("The database holds an unknown ") + what + ", \"" +
                                       text + "\"; was it written by a newer program?"};
}

base::Status check_exists(soci::session& sql, const std::string& trial_id) {
  int count = 0;
  sql << "SELECT count(*) FROM trial WHERE id = :id", soci::use(trial_id), soci::into(count);
  if (count == 0) return unknown_trial();
  return base::Done{};
}

base::Status check_running(soci::session& sql, const std::string& trial_id) {
  std::string ended_utc;
  sql << "SELECT coalesce(ended_utc, '') FROM trial WHERE id = :id", soci::use(trial_id),
      soci::into(ended_utc);
  if (!sql.got_data()) return unknown_trial();
  if (!ended_utc.empty()) return Error{ErrorCode::conflict, "This trial has already ended."};
  return base::Done{};
}

base::Result<StoredTrial> trial(Store& store, const std::string& trial_id) {
  TrialSelection selection;
  selection.conditions = {"t.id = :id"};
  selection.parameters = {{"id", trial_id}};
  return reading(store, [&](soci::session& sql) -> base::Result<StoredTrial> {
    const base::Result<std::vector<StoredTrial>> found = load_trials(sql, selection);
    if (!found) return found.error();
    if (found->empty()) return unknown_trial();
    return found->front();
  });
}

base::Result<std::vector<Chunk>> trial_chunks(Store& store, const std::string& trial_id,
                                              const std::string& kind) {
  return reading(store, [&](soci::session& sql) -> base::Result<std::vector<Chunk>> {
    if (base::Status status = check_exists(sql, trial_id); !status) return status.error();
    return load_chunks(store.connection(), trial_id, kind);
  });
}

base::Result<std::vector<assessment::Event>> trial_events(Store& store,
                                                          const std::string& trial_id) {
  return reading(store, [&](soci::session& sql) -> base::Result<std::vector<assessment::Event>> {
    if (base::Status status = check_exists(sql, trial_id); !status) return status.error();
    return load_events(sql, trial_id);
  });
}

base::Result<std::vector<assessment::TrialStep>> trial_steps(Store& store,
                                                             const std::string& trial_id) {
  return reading(store,
                 [&](soci::session& sql) -> base::Result<std::vector<assessment::TrialStep>> {
                   if (base::Status status = check_exists(sql, trial_id); !status) {
                     return status.error();
                   }
                   return load_steps(sql, trial_id);
                 });
}

base::Result<assessment::Verdict> trial_verdict(Store& store, const std::string& trial_id) {
  return reading(store, [&](soci::session& sql) -> base::Result<assessment::Verdict> {
    if (base::Status status = check_exists(sql, trial_id); !status) return status.error();
    return load_verdict(sql, trial_id);
  });
}

}  // namespace database
