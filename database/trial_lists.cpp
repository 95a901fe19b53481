// Lists of trials: one query for the trials, one for their metrics, however many there are.
#include <optional>
#include <unordered_map>
#include <utility>

#include "database/trial_rows.h"

namespace database {
namespace {

// The condition of a selection: "a AND b".
std::string where(const TrialSelection& selection) {
  std::string text = "1 = 1";
  for (const std::string& condition : selection.conditions) text += " AND " + condition;
  return text;
}

void bind(soci::statement& statement, const TrialSelection& selection) {
  for (const auto& [name, value] : selection.parameters) {
    statement.exchange(soci::use(value, name));
  }
}

void run(soci::statement& statement, const std::string& query) {
  statement.alloc();
  statement.prepare(query);
  statement.define_and_bind();
  statement.execute();
}

// One row of the query below, in the words of the database.
struct Row {
  StoredTrial trial;
  std::string source, seed, end_reason, outcome, level;
  int interrupted = 0;
};

constexpr const char* kColumns =
    "SELECT t.id, t.person_id, coalesce(t.enrolment_id, ''), coalesce(n.curriculum_id, ''), "
    "t.exercise_id, "
    "coalesce(t.exercise_version_id, ''), t.ordinal, t.source, t.dataset, t.apparatus, t.device, "
    "t.seed, t.build, t.isa, t.anatomy_sha256, t.instruments_sha256, t.input_sha256, "
    "t.state_hash, t.started_utc, coalesce(t.ended_utc, ''), coalesce(t.end_reason, ''), "
    "t.end_time_s, t.paused_s, t.slowed_s, t.interrupted, coalesce(t.outcome, ''), "
    "coalesce(t.voided_utc, ''), coalesce(t.voided_by, ''), coalesce(t.void_reason, ''), "
    "coalesce(i.display_name, ''), "
    "coalesce((SELECT e.level FROM experience e WHERE e.person_id = t.person_id "
    "AND e.declared_utc <= t.started_utc ORDER BY e.declared_utc DESC, e.ordinal DESC LIMIT 1), "
    "'') FROM trial t LEFT JOIN identity i ON i.person_id = t.person_id "
    "LEFT JOIN enrolment n ON n.id = t.enrolment_id WHERE ";

// In the order of kColumns.
void receive(soci::statement& statement, Row& row) {
  NewTrial& head = row.trial.head;
  for (std::string* text : {&head.id, &head.person_id, &head.enrolment_id, &row.trial.curriculum_id,
                            &head.exercise_id, &head.exercise_version_id}) {
    statement.exchange(soci::into(*text));
  }
  statement.exchange(soci::into(row.trial.ordinal));
  for (std::string* text :
       {&row.source, &head.dataset, &head.apparatus, &head.device, &row.seed, &head.build,
        &head.isa, &head.anatomy_sha256, &head.instruments_sha256, &row.trial.input_sha256,
        &row.trial.state_hash, &head.started_utc, &row.trial.ended_utc, &row.end_reason}) {
    statement.exchange(soci::into(*text));
  }
  for (double* number : {&row.trial.end_time_s, &row.trial.paused_s, &row.trial.slowed_s}) {
    statement.exchange(soci::into(*number));
  }
  statement.exchange(soci::into(row.interrupted));
  for (std::string* text : {&row.outcome, &row.trial.voided_utc, &row.trial.voided_by,
                            &row.trial.void_reason, &row.trial.person_name, &row.level}) {
    statement.exchange(soci::into(*text));
  }
}

// An empty text stands for null.
template <typename Word>
bool parse_optional(const std::string& text, std::optional<Word>& value) {
  using assessment::parse;
  Word parsed{};
  value.reset();
  if (text.empty()) return true;
  if (!parse(text, parsed)) return false;
  value = parsed;
  return true;
}

base::Result<StoredTrial> trial_of(const Row& row) {
  StoredTrial trial = row.trial;
  trial.head.seed = std::stoull(row.seed);
  trial.interrupted = row.interrupted != 0;
  if (!assessment::parse(row.source, trial.head.source)) return unknown_word("source", row.source);
  if (!parse_optional(row.end_reason, trial.end_reason)) {
    return unknown_word("end of a trial", row.end_reason);
  }
  if (!parse_optional(row.outcome, trial.outcome)) return unknown_word("outcome", row.outcome);
  if (!parse_optional(row.level, trial.level)) return unknown_word("level", row.level);
  return trial;
}

void add_metrics(soci::session& sql, const TrialSelection& selection,
                 std::vector<StoredTrial>& trials) {
  std::unordered_map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < trials.size(); ++i) index.emplace(trials[i].head.id, i);

  std::string trial_id;
  assessment::MetricValue metric;
  soci::statement select(sql);
  bind(select, selection);
  select.exchange(soci::into(trial_id));
  select.exchange(soci::into(metric.id));
  select.exchange(soci::into(metric.version));
  select.exchange(soci::into(metric.value));
  std::string query =
      "SELECT t.id, m.metric, m.version, m.value FROM trial t "
      "JOIN metric_value m ON m.trial_id = t.id WHERE " +
      where(selection);
  if (!selection.only_metric.empty()) {
    select.exchange(soci::use(selection.only_metric, "metric"));
    query += " AND m.metric = :metric";
  }
  run(select, query + " ORDER BY t.id, m.position");
  while (select.fetch()) {
    const auto found = index.find(trial_id);
    if (found != index.end()) trials[found->second].metrics.push_back(metric);
  }
}

}  // namespace

base::Result<std::vector<StoredTrial>> load_trials(soci::session& sql,
                                                   const TrialSelection& selection) {
  std::vector<StoredTrial> trials;
  Row row;
  soci::statement select(sql);
  bind(select, selection);
  receive(select, row);
  run(select, kColumns + where(selection) + " ORDER BY t.person_id, t.exercise_id, t.ordinal");
  while (select.fetch()) {
    base::Result<StoredTrial> trial = trial_of(row);
    if (!trial) return trial.error();
    trials.push_back(*std::move(trial));
  }
  if (selection.with_metrics) add_metrics(sql, selection, trials);
  return trials;
}

base::Result<std::vector<StoredTrial>> trials(Store& store, const TrialFilter& filter) {
  TrialSelection selection;
  selection.with_metrics = filter.with_metrics;
  selection.only_metric = filter.only_metric;
  const auto add = [&](const char* column, const char* name, const std::string& value) {
    if (value.empty()) return;
    selection.conditions.push_back(std::string("t.") + column + " = :" + name);
    selection.parameters.emplace_back(name, value);
  };
  add("person_id", "person", filter.person_id);
  add("exercise_id", "exercise", filter.exercise_id);
  add("dataset", "dataset", filter.dataset);
  if (!filter.curriculum_id.empty()) {
    // a selection of its own, as the list of metrics knows the trial alone
    selection.conditions.emplace_back(
        "(t.enrolment_id IS NULL OR t.enrolment_id IN "
        "(SELECT id FROM enrolment WHERE curriculum_id = :curriculum))");
    selection.parameters.emplace_back("curriculum", filter.curriculum_id);
  }
  if (filter.source) add("source", "source", assessment::word(*filter.source));
  if (filter.finished_only) selection.conditions.push_back("t.ended_utc IS NOT NULL");
  return reading(store, [&](soci::session& sql) { return load_trials(sql, selection); });
}

base::Result<std::vector<TrialCount>> trial_counts(Store& store) {
  return reading(store, [](soci::session& sql) -> base::Result<std::vector<TrialCount>> {
    std::vector<TrialCount> counts;
    TrialCount count;
    soci::statement select =
        (sql.prepare << "SELECT person_id, exercise_id, count(*), "
                        "sum(CASE WHEN outcome = 'passed' AND voided_utc IS NULL "
                        "AND interrupted = 0 THEN 1 ELSE 0 END), max(started_utc) "
                        "FROM trial GROUP BY person_id, exercise_id "
                        "ORDER BY person_id, exercise_id",
         soci::into(count.person_id), soci::into(count.exercise_id), soci::into(count.started),
         soci::into(count.passed), soci::into(count.last_started_utc));
    select.execute();
    while (select.fetch()) counts.push_back(count);
    return counts;
  });
}

}  // namespace database
