// What there is to train: the plan, an exercise's briefing, the vessel, the metrics.
#include <nlohmann/json.hpp>

#include "app/server/json_body.h"
#include "app/server/routes/handlers.h"
#include "app/server/site.h"
#include "app/server/training_record.h"
#include "app/server/views/briefing_view.h"
#include "app/server/views/json_views.h"
#include "app/server/views/progress_view.h"

namespace app {

base::Result<Response> get_training(Call& call) {
  const auto record = training_record(call.store, call.site, call.me().person.id);
  if (!record) return record.error();
  const auto bands = call.site.expert_bands.current(call.store);
  if (!bands) return bands.error();
  const auto training = training_json(call.store, *record, call.site.scenes.library(), **bands);
  if (!training) return training.error();
  return json_response(*training);
}

base::Result<Response> get_exercise(Call& call) {
  const auto record = training_record(call.store, call.site, call.me().person.id);
  if (!record) return record.error();
  const std::string& id = call.parameter("id");
  const curricula::Exercise* exercise = record->curriculum->find(id);
  const curricula::ExerciseState* state = record->progression.find(id);
  if (exercise == nullptr || state == nullptr) {
    return base::Error{base::ErrorCode::not_found, "This exercise is not in your curriculum."};
  }
  return json_response(
      briefing_json(*record->curriculum, *exercise, *state, call.site.scenes.library()));
}

base::Result<Response> get_mesh(Call& call) {
  const auto mesh = call.site.meshes.mesh(call.parameter("id"));
  if (!mesh) return mesh.error();
  Response response;
  response.type = "model/gltf-binary";
  response.headers.emplace_back("ETag", (*mesh)->tag);
  response.headers.emplace_back("Cache-Control", "private, no-cache");
  if (call.request.header("if-none-match") == (*mesh)->tag) {
    response.status = 304;
  } else {
    response.body = (*mesh)->bytes;
  }
  return response;
}

base::Result<Response> get_metrics(Call&) { return json_response({{"metrics", metrics_json()}}); }

}  // namespace app
