// Beginning a trial, and reading what came of one.
#include <nlohmann/json.hpp>

#include "app/server/actor_names.h"
#include "app/server/begun_trial.h"
#include "app/server/json_body.h"
#include "app/server/routes/handlers.h"
#include "app/server/site.h"
#include "app/server/training_record.h"
#include "app/server/views/comment_view.h"
#include "app/server/views/trial_view.h"
#include "app/server/views/words.h"
#include "app/session/trial_file.h"
#include "app/session/trial_keeper.h"
#include "database/comments.h"

namespace app {
namespace {

using nlohmann::json;

base::Result<RunningTrial> start_trial(Call& call, const curricula::Curriculum& curriculum,
                                       const curricula::Exercise& exercise,
                                       const std::string& device) {
  const std::string& person_id = call.me().person.id;
  const auto scene = call.site.scenes.scene(exercise.scene);
  if (!scene) return scene.error();
  TrialHead head;
  head.person_id = person_id;
  head.curriculum_id = curriculum.id;
  head.exercise_id = exercise.id;
  head.device = device;
  head.seed = exercise.scene.seed;
  const auto begun = begin(call.store, head, **scene);
  if (!begun) return begun.error();

  const RunningTrial running{begun->trial_id, person_id, exercise.id,        begun->ordinal,
                             false,           device,    database::utc_now()};
  const auto started = call.site.live.start(
      running, {begun->trial_id, person_id, *scene, exercise,
                std::make_unique<FilingKeeper>(call.site.options.database_url, begun->trial_id)});
  if (!started) return started.error();
  return running;
}

// The exercise as it was when the trial was made; absent for trials that were not made here.
base::Result<std::optional<curricula::Exercise>> exercise_then(Call& call,
                                                               const database::StoredTrial& trial) {
  auto exercise = exercise_of(call.store, trial, call.site.scenes.library().catalogue());
  if (exercise) return std::optional<curricula::Exercise>(*std::move(exercise));
  if (exercise.error().code != base::ErrorCode::not_found) return exercise.error();
  return std::optional<curricula::Exercise>{};
}

// Whoever teaches may judge the trials they may see, but not their own.
bool may_judge(const database::Person& viewer, const database::StoredTrial& trial) {
  return (viewer.role == database::Role::instructor ||
          viewer.role == database::Role::administrator) &&
         viewer.id != trial.head.person_id;
}

}  // namespace

base::Result<Response> post_trial(Call& call) {
  const auto body = read_text_fields(call.request, {"exercise_id", "device"});
  if (!body) return body.error();
  const std::string exercise_id = (*body)["exercise_id"], device = (*body)["device"];
  if (const auto plain = check_device(device); !plain) return plain.error();

  const std::string& person_id = call.me().person.id;
  if (const auto reserved = call.site.live.reserve(person_id); !reserved) return reserved.error();
  const Reservation reservation(call.site.live, person_id);
  const auto record = training_record(call.store, call.site, person_id);
  if (!record) return record.error();
  const auto allowed =
      curricula::may_start(*record->curriculum, record->histories, record->today, exercise_id);
  if (!allowed) return allowed.error();
  const auto running =
      start_trial(call, *record->curriculum, *record->curriculum->find(exercise_id), device);
  if (!running) return running.error();
  const auto begun = begun_json(*record, call.site, *running);
  if (!begun) return begun.error();
  return json_response(*begun, 201);
}

base::Result<Response> get_trial(Call& call) {
  const auto trial = database::trial(call.store, call.parameter("id"));
  if (!trial) return trial.error();
  if (!trial->end_reason) {
    return base::Error{base::ErrorCode::conflict,
                       "This trial is still running; its debrief comes when it has ended."};
  }
  const auto exercise = exercise_then(call, *trial);
  if (!exercise) return exercise.error();
  auto debrief = debrief_json(call.store, *trial, *exercise ? &**exercise : nullptr);
  if (!debrief) return debrief.error();

  const auto record = training_record(call.store, call.site, trial->head.person_id);
  if (!record) return record.error();
  const auto* state = record->progression.find(trial->head.exercise_id);
  json answer = *std::move(debrief);
  answer["progress_sentence"] = state == nullptr ? "" : state->progress.sentence;
  answer["status"] = assessment::word(state == nullptr ? assessment::ExerciseStatus::available
                                                       : state->progress.status);
  answer["void"] = nullptr;
  if (!trial->voided_utc.empty()) {
    const auto names = ActorNames::load(call.store);
    if (!names) return names.error();
    answer["void"] = {{"voided_utc", trial->voided_utc},
                      {"voided_by", names->actor(trial->voided_by)},
                      {"reason", trial->void_reason}};
  }
  const auto comments = database::trial_comments(call.store, trial->head.id);
  if (!comments) return comments.error();
  answer["comments"] = json::array();
  for (const database::Comment& comment : *comments) {
    answer["comments"].push_back(comment_json(comment, call.me().person.id));
  }
  answer["may_judge"] = may_judge(call.me().person, *trial);
  return json_response(answer);
}

}  // namespace app
