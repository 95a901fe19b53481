#include "app/server/begun_trial.h"

#include <algorithm>
#include <cctype>

#include "app/server/views/briefing_view.h"

namespace app {

using nlohmann::json;

base::Status check_device(const std::string& device) {
  const bool plain = std::all_of(device.begin(), device.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '+' || c == ' ' || c == '.';
  });
  if (!device.empty() && device.size() <= 64 && plain) return base::Done{};
  return base::Error{base::ErrorCode::invalid_input,
                     "Name the device by 1 to 64 letters, digits, blanks and hyphens."};
}

base::Result<json> running_briefing_json(const TrainingRecord& record, Site& site,
                                         const RunningTrial& trial) {
  const curricula::Exercise* exercise = record.curriculum->find(trial.exercise_id);
  const curricula::ExerciseState* state = record.progression.find(trial.exercise_id);
  if (exercise == nullptr || state == nullptr) {
    return base::Error{base::ErrorCode::not_found,
                       "The exercise of this running trial is no longer in the curriculum."};
  }
  return briefing_json(*record.curriculum, *exercise, *state, site.scenes.library());
}

base::Result<json> begun_json(const TrainingRecord& record, Site& site, const RunningTrial& trial) {
  auto briefing = running_briefing_json(record, site, trial);
  if (!briefing) return briefing.error();
  return json{{"trial_id", trial.trial_id},
              {"ordinal", trial.ordinal},
              {"practice", trial.practice},
              {"briefing", *std::move(briefing)}};
}

}  // namespace app
