// The parts of a trial as rows, inside a transaction. For database/*.cpp only.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include <soci/soci.h>

#include "database/connection.h"
#include "database/trials.h"

namespace database {

base::Error unknown_trial();
// corrupt_data: the row holds a word this program does not know.
base::Error unknown_word(const char* what, const std::string& text);

// not_found when it does not exist, conflict when it has ended.
base::Status check_running(soci::session& sql, const std::string& trial_id);
base::Status check_exists(soci::session& sql, const std::string& trial_id);

// The bytes go through SQLite's own statement: SOCI would need them as text or copied twice.
void insert_chunks(Store::Connection& connection, const std::string& trial_id,
                   std::span<const Chunk> chunks);
std::vector<Chunk> load_chunks(Store::Connection& connection, const std::string& trial_id,
                               const std::string& kind);

void insert_events(soci::session& sql, const std::string& trial_id,
                   std::span<const assessment::Event> events);
void insert_steps(soci::session& sql, const std::string& trial_id,
                  std::span<const assessment::TrialStep> steps);
void insert_metrics(soci::session& sql, const std::string& trial_id,
                    std::span<const assessment::MetricValue> metrics);
// Adds the next score and makes its outcome the trial's.
void insert_score(soci::session& sql, const std::string& trial_id, const std::string& rule_version,
                  const assessment::Verdict& verdict);

// Which trials, and what of them. The conditions are joined by AND.
struct TrialSelection {
  std::vector<std::string> conditions;                          // on t (trial)
  std::vector<std::pair<std::string, std::string>> parameters;  // name, value
  bool with_metrics = true;
  std::string only_metric;
};
// Trials with level and, where wanted, metrics; by person, exercise, ordinal.
base::Result<std::vector<StoredTrial>> load_trials(soci::session& sql,
                                                   const TrialSelection& selection);

}  // namespace database
