// What happens to a trial apart from being made: closed after a crash, taken out of the counts.
#include "database/audit_chain.h"
#include "database/text_limits.h"
#include "database/trial_rows.h"

namespace database {
namespace {

using base::Error;
using base::ErrorCode;

std::vector<std::string> load_unfinished(soci::session& sql) {
  std::vector<std::string> ids;
  std::string id;
  soci::statement select =
      (sql.prepare << "SELECT id FROM trial WHERE ended_utc IS NULL ORDER BY id", soci::into(id));
  select.execute();
  while (select.fetch()) ids.push_back(id);
  return ids;
}

// The exercise and version a trial was made under, as its rule is called; empty when unknown.
std::string rule_version_of(soci::session& sql, const std::string& trial_id) {
  std::string exercise;
  int version = 0;
  sql << "SELECT e.exercise_id, e.version FROM trial t "
         "JOIN exercise_version e ON e.id = t.exercise_version_id WHERE t.id = :id",
      soci::use(trial_id), soci::into(exercise), soci::into(version);
  return sql.got_data() ? exercise + "@" + std::to_string(version) : std::string();
}

void abort_trial(soci::session& sql, const std::string& trial_id) {
  execute(sql,
          "UPDATE trial SET end_reason = 'aborted', interrupted = 1, "
          "ended_utc = coalesce((SELECT max(c.written_utc) FROM trace_chunk c "
          "WHERE c.trial_id = trial.id), started_utc) WHERE id = :id",
          trial_id);
  assessment::Verdict verdict;
  verdict.outcome = assessment::Outcome::invalid;
  verdict.sentence =
      "The program stopped while this trial was running; it is kept up to its last recorded "
      "second and does not count.";
  insert_score(sql, trial_id, rule_version_of(sql, trial_id), verdict);
}

// What voiding may change, as hashed into the audit.
std::string hash_of_voiding(const std::string& trial_id, const std::string& utc,
                            const std::string& by, const std::string& reason) {
  return hash_of({trial_id, utc, by, reason});
}

}  // namespace

base::Result<std::vector<std::string>> unfinished_trials(Store& store) {
  return reading(store, [](soci::session& sql) -> base::Result<std::vector<std::string>> {
    return load_unfinished(sql);
  });
}

base::Result<int> abort_unfinished_trials(Store& store) {
  return writing(store, [](soci::session& sql) -> base::Result<int> {
    const std::vector<std::string> ids = load_unfinished(sql);
    for (const std::string& id : ids) abort_trial(sql, id);
    return static_cast<int>(ids.size());
  });
}

base::Status void_trial(Store& store, const std::string& trial_id, const std::string& reason,
                        const std::string& actor) {
  if (reason.empty()) {
    return Error{ErrorCode::invalid_input, "Say why this trial shall not count."};
  }
  if (base::Status status = check_text("reason", reason); !status) return status;
  if (base::Status status = check_name("actor", actor); !status) return status;
  return writing(store, [&](soci::session& sql) -> base::Status {
    if (base::Status status = check_exists(sql, trial_id); !status) return status;
    if (check_running(sql, trial_id)) {
      return Error{ErrorCode::conflict, "This trial is still running; void it when it has ended."};
    }
    const std::string now = utc_now();
    execute(sql,
            "UPDATE trial SET voided_utc = :utc, voided_by = :by, void_reason = :reason "
            "WHERE id = :id AND voided_utc IS NULL",
            now, actor, reason, trial_id);
    if (changed_rows(store.connection()) == 0) {
      return Error{ErrorCode::conflict, "This trial is voided already."};
    }
    add_audit(sql, {actor, "trial.void", "trial:" + trial_id, hash_of_voiding(trial_id, "", "", ""),
                    hash_of_voiding(trial_id, now, actor, reason)});
    return base::Done{};
  });
}

}  // namespace database
