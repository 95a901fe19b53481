#include "app/session/comparison_data.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <map>
#include <span>

#include "app/session/build_info.h"
#include "app/session/published_data.h"
#include "app/session/recording.h"
#include "database/people.h"
#include "database/trials.h"

namespace app {
namespace {

struct Dataset {
  const char* name;
  const char* title;
  const char* apparatus;
  assessment::Source source;
};

constexpr Dataset kDatasets[] = {
    {kPaperDataset, "Published data", kPaperApparatus, assessment::Source::published_data},
    {"live", "Trials made here", "Cathedra", assessment::Source::live},
    {"simulated", "Simulated operators", "Cathedra", assessment::Source::simulated_operator}};

const Dataset* find_dataset(const std::string& name) {
  const auto found = std::find_if(std::begin(kDatasets), std::end(kDatasets),
                                  [&](const Dataset& dataset) { return dataset.name == name; });
  return found == std::end(kDatasets) ? nullptr : found;
}

bool counts(const database::StoredTrial& trial) {
  return trial.end_reason == assessment::EndReason::completed && trial.voided_utc.empty() &&
         !trial.interrupted && !trial.metrics.empty();
}

// Over what the comparison was computed from, so that a report can be traced to its rows.
std::string hash_rows(const std::vector<assessment::TrialValue>& rows) {
  std::string text;
  for (const assessment::TrialValue& row : rows) {
    char value[32];
    std::snprintf(value, sizeof value, "%.17g", row.value);
    text +=
        row.group + "," + row.participant + "," + std::to_string(row.trial) + "," + value + "\n";
  }
  return sha256_hex(std::as_bytes(std::span(text)));
}

}  // namespace

bool is_dataset(const std::string& name) { return find_dataset(name) != nullptr; }

base::Result<ComparisonData> comparison_data(database::Store& store,
                                             const curricula::Exercise& exercise,
                                             const std::string& dataset,
                                             const PersonFilter& may_count) {
  const Dataset* wanted = find_dataset(dataset);
  if (!wanted) {
    return base::Error{base::ErrorCode::invalid_input,
                       "there is no data set \"" + dataset + "\"; use paper, live or simulated"};
  }
  database::TrialFilter filter;
  filter.exercise_id = exercise.id;
  filter.source = wanted->source;
  filter.only_metric = "time_s";
  const auto trials = database::trials(store, filter);
  if (!trials) return trials.error();

  ComparisonData data;
  std::map<std::string, std::string> group_of;  // person -> level at the first trial that counts
  std::map<std::string, std::string> name_of;   // person -> display name, made unique
  std::map<std::string, int> names;
  for (const database::StoredTrial& trial : *trials) {
    if (!counts(trial) || !trial.level) continue;
    const std::string& person = trial.head.person_id;
    if (may_count && !may_count(person)) continue;
    if (group_of.emplace(person, database::word(*trial.level)).second) {
      const int same = ++names[trial.person_name];
      name_of[person] =
          same == 1 ? trial.person_name : trial.person_name + " (" + std::to_string(same) + ")";
    }
    data.rows.push_back(
        {group_of[person], name_of[person], trial.ordinal, trial.metrics.front().value});
  }
  data.subject.exercise_id = exercise.id;
  data.subject.exercise_title = exercise.title.at("en");
  data.subject.dataset = dataset;
  data.subject.dataset_title = wanted->title;
  data.subject.apparatus = wanted->apparatus;
  data.subject.data_sha256 = hash_rows(data.rows);
  data.subject.program = "Cathedra " + build_id();
  return data;
}

}  // namespace app
