// The trials that run right now: one's own, and those one may watch.
#include <nlohmann/json.hpp>

#include "app/server/access.h"
#include "app/server/begun_trial.h"
#include "app/server/json_body.h"
#include "app/server/routes/handlers.h"
#include "app/server/site.h"
#include "app/server/training_record.h"

namespace app {
namespace {

using nlohmann::json;

base::Result<json> watched_json(Call& call, const LiveTrials::Running& running,
                                const database::Person& person) {
  const RunningTrial& trial = running.about;
  const auto record = training_record(call.store, call.site, person.id);
  if (!record) return record.error();
  auto briefing = running_briefing_json(*record, call.site, trial);
  if (!briefing) return briefing.error();
  const json title = (*briefing)["title"];
  return json{{"trial_id", trial.trial_id},
              {"person_id", trial.person_id},
              {"person_name", person.display_name},
              {"exercise_id", trial.exercise_id},
              {"exercise_title", title},
              {"ordinal", trial.ordinal},
              {"started_utc", trial.started_utc},
              {"device", trial.device},
              {"paused", running.paused},
              {"briefing", *std::move(briefing)}};
}

}  // namespace

base::Result<Response> get_live_mine(Call& call) {
  const std::string& person_id = call.me().person.id;
  const auto running = call.site.live.of_person(person_id);
  if (!running) return json_response({{"trial", nullptr}});
  const auto record = training_record(call.store, call.site, person_id);
  if (!record) return record.error();
  const auto begun = begun_json(*record, call.site, *running);
  if (!begun) return begun.error();
  return json_response({{"trial", *begun}});
}

base::Result<Response> get_live(Call& call) {
  json trials = json::array();
  for (const LiveTrials::Running& running : call.site.live.running()) {
    const auto person = database::person_by_id(call.store, running.about.person_id);
    if (!person) return person.error();
    if (!may_see(call.me().person, *person)) continue;
    auto watched = watched_json(call, running, *person);
    if (!watched) return watched.error();
    trials.push_back(*std::move(watched));
  }
  return json_response({{"trials", trials}});
}

}  // namespace app
