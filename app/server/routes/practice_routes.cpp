// Practice: any exercise of one's curriculum, locked or used up or not, judged like a trial and
// kept nowhere.
#include <nlohmann/json.hpp>

#include "app/server/begun_trial.h"
#include "app/server/json_body.h"
#include "app/server/routes/handlers.h"
#include "app/server/site.h"
#include "app/server/throttle.h"
#include "app/server/training_record.h"
#include "app/server/views/trial_view.h"
#include "app/session/trial_keeper.h"

namespace app {
namespace {

using nlohmann::json;

base::Result<RunningTrial> start_practice(Call& call, const curricula::Exercise& exercise,
                                          const std::string& device) {
  Site& site = call.site;
  const std::string& person_id = call.me().person.id;
  const auto scene = site.scenes.scene(exercise.scene);
  if (!scene) return scene.error();

  RunningTrial running;
  running.trial_id = database::new_id();
  running.person_id = person_id;
  running.exercise_id = exercise.id;
  running.practice = true;
  running.device = device;
  running.started_utc = database::utc_now();
  const auto keep_result = [&site, running](const LiveResult& result) {
    site.practice.keep(running.trial_id, {running.person_id, running.exercise_id, result},
                       steady_seconds());
  };
  const auto started = site.live.start(
      running, {running.trial_id, person_id, *scene, exercise, std::make_unique<PracticeKeeper>()},
      keep_result);
  if (!started) return started.error();
  return running;
}

std::string sentence_of(const LiveResult& result) {
  std::string sentence = result.judgement.verdict.sentence;
  if (sentence.empty()) sentence = "This exercise is not judged by a rule.";
  if (result.interrupted) sentence += " As a trial it would not have counted: it was interrupted.";
  return sentence;
}

}  // namespace

base::Result<Response> post_practice(Call& call) {
  const auto body = read_text_fields(call.request, {"exercise_id", "device"});
  if (!body) return body.error();
  const std::string exercise_id = (*body)["exercise_id"], device = (*body)["device"];
  if (const auto plain = check_device(device); !plain) return plain.error();

  const std::string& person_id = call.me().person.id;
  if (const auto reserved = call.site.live.reserve(person_id); !reserved) return reserved.error();
  const Reservation reservation(call.site.live, person_id);
  const auto record = training_record(call.store, call.site, person_id);
  if (!record) return record.error();
  const curricula::Exercise* exercise = record->curriculum->find(exercise_id);
  if (exercise == nullptr) {
    return base::Error{base::ErrorCode::not_found,
                       "There is no exercise \"" + exercise_id +
                           "\" in this curriculum: choose one from My training."};
  }
  const auto running = start_practice(call, *exercise, device);
  if (!running) return running.error();
  const auto begun = begun_json(*record, call.site, *running);
  if (!begun) return begun.error();
  return json_response(*begun, 201);
}

base::Result<Response> get_practice_result(Call& call) {
  const auto practice = call.site.practice.find(call.parameter("id"));
  if (!practice) {
    return base::Error{base::ErrorCode::conflict,
                       "This practice is still going on; its result comes when it has ended."};
  }
  const LiveResult& result = practice->result;
  return json_response({{"exercise_id", practice->exercise_id},
                        {"end_reason", assessment::word(result.end_reason)},
                        {"verdict_sentence", sentence_of(result)},
                        {"criteria", criteria_json(result.judgement.verdict.criteria)},
                        {"metrics", metrics_json(result.judgement.metrics)}});
}

}  // namespace app
