#include "app/server/training_record.h"

#include <array>
#include <ctime>
#include <utility>

namespace app {
namespace {

std::vector<curricula::ExerciseHistory> histories_of(
    const std::vector<database::StoredTrial>& trials) {
  std::vector<curricula::ExerciseHistory> histories;
  for (const database::StoredTrial& trial : trials) {
    if (histories.empty() || histories.back().exercise_id != trial.head.exercise_id) {
      histories.push_back({trial.head.exercise_id, {}});
    }
    curricula::PastTrial past;
    past.outcome.outcome = trial.outcome.value_or(assessment::Outcome::invalid);
    past.outcome.voided = !trial.voided_utc.empty();
    past.outcome.interrupted = trial.interrupted;
    past.date = local_day(trial.head.started_utc);
    histories.back().trials.push_back(past);
  }
  return histories;
}

}  // namespace

std::vector<const database::StoredTrial*> TrainingRecord::trials_of(
    const std::string& exercise_id) const {
  std::vector<const database::StoredTrial*> found;
  for (const database::StoredTrial& trial : trials) {
    if (trial.head.exercise_id == exercise_id) found.push_back(&trial);
  }
  return found;
}

base::Result<TrainingRecord> training_record(database::Store& store, Site& site,
                                             const std::string& person_id) {
  auto curriculum = site.curricula.of_person(store, site.scenes.library().catalogue(), person_id);
  if (!curriculum) return curriculum.error();
  return training_record(store, *std::move(curriculum), person_id);
}

base::Result<TrainingRecord> training_record(
    database::Store& store, std::shared_ptr<const curricula::Curriculum> curriculum,
    const std::string& person_id) {
  TrainingRecord record;
  record.curriculum = std::move(curriculum);
  database::TrialFilter filter;
  filter.person_id = person_id;
  filter.curriculum_id = record.curriculum->id;
  auto trials = database::trials(store, filter);
  if (!trials) return trials.error();
  record.trials = *std::move(trials);
  record.histories = histories_of(record.trials);
  record.today = local_day(database::utc_now());
  record.progression =
      curricula::progression_of(*record.curriculum, record.histories, record.today);
  return record;
}

std::optional<double> metric_value(const database::StoredTrial& trial, const std::string& metric) {
  for (const assessment::MetricValue& value : trial.metrics) {
    if (value.id == metric) return value.value;
  }
  return std::nullopt;
}

std::string local_day(const std::string& utc) {
  std::tm parts{};
  if (strptime(utc.c_str(), "%Y-%m-%dT%H:%M:%S", &parts) == nullptr) return utc.substr(0, 10);
  const std::time_t instant = timegm(&parts);
  std::tm local{};
  localtime_r(&instant, &local);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", &local);
  return text.data();
}

}  // namespace app
