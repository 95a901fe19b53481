#include "app/session/published_data.h"

#include <charconv>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include "assessment/metrics.h"
#include "database/people.h"
#include "database/trials.h"

namespace app {
namespace {

struct Row {
  std::string task, group, participant;
  int trial = 0;
  double seconds = 0.0;
};

template <typename T>
bool parse_number(const std::string& text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

base::Result<std::vector<Row>> read_rows(const std::string& path) {
  std::ifstream file(path);
  if (!file) {
    return base::Error{base::ErrorCode::not_found, "cannot read the published data at " + path};
  }
  std::vector<Row> rows;
  std::string line;
  std::getline(file, line);  // the header
  for (int number = 2; std::getline(file, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) continue;
    std::istringstream fields(line);
    Row row;
    std::string trial, seconds;
    std::getline(fields, row.task, ',');
    std::getline(fields, row.group, ',');
    std::getline(fields, row.participant, ',');
    std::getline(fields, trial, ',');
    std::getline(fields, seconds, ',');
    if (!parse_number(trial, row.trial) || !parse_number(seconds, row.seconds)) {
      return base::Error{
          base::ErrorCode::corrupt_data,
          path + ":" + std::to_string(number) + ": expected task,group,participant,trial,seconds"};
    }
    rows.push_back(row);
  }
  return rows;
}

base::Result<std::string> published_person(database::Store& store, const Row& row) {
  const std::string name = "published:" + row.participant;
  const auto known = database::person_by_name(store, name);
  if (known) return known->id;
  database::NewPerson person;
  person.name = name;
  person.display_name = row.participant;
  person.kind = database::PersonKind::published;
  database::Level level;
  if (database::parse(row.group, level)) person.level = level;
  const auto added = database::add_person(store, person, "system");
  if (!added) return added.error();
  return added->id;
}

}  // namespace

base::Result<int> load_published_data(database::Store& store, const std::string& csv_path) {
  const auto rows = read_rows(csv_path);
  if (!rows) return rows.error();
  database::TrialFilter filter;
  filter.dataset = kPaperDataset;
  const auto present = database::trials(store, filter);
  if (!present) return present.error();
  if (present->size() == rows->size()) return 0;

  // a load that was cut off goes on where it stopped: rows are filed in order
  std::map<std::string, std::size_t> there;  // person and exercise -> trials
  for (const database::StoredTrial& trial : *present) {
    ++there[trial.head.person_id + trial.head.exercise_id];
  }
  int added = 0;
  for (const Row& row : *rows) {
    const auto person = published_person(store, row);
    if (!person) return person.error();
    if (static_cast<std::size_t>(row.trial) <= there[*person + row.task]) continue;
    database::NewTrial trial;
    trial.id = database::new_id();
    trial.person_id = *person;
    trial.exercise_id = row.task;
    trial.source = assessment::Source::published_data;
    trial.dataset = kPaperDataset;
    trial.apparatus = kPaperApparatus;
    trial.device = "Phantom haptic device";
    const std::vector<assessment::MetricValue> metrics = {
        {"time_s", assessment::find_metric("time_s")->version, row.seconds}};
    const base::Status imported = database::import_trial(store, trial, metrics);
    if (!imported) return imported.error();
    ++added;
  }
  return added;
}

}  // namespace app
