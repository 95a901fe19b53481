// Who trains, and how they get on.
#include <nlohmann/json.hpp>

#include "app/server/json_body.h"
#include "app/server/routes/handlers.h"
#include "app/server/site.h"
#include "app/server/training_record.h"
#include "app/server/views/progress_view.h"

namespace app {
namespace {

using nlohmann::json;

base::Result<std::vector<database::Person>> people_seen_by(database::Store& store,
                                                           const database::Person& viewer) {
  if (viewer.role == database::Role::administrator) return database::people(store);
  return database::people_of_instructor(store, viewer.id);
}

}  // namespace

base::Result<Response> get_people(Call& call) {
  const auto people = people_seen_by(call.store, call.me().person);
  if (!people) return people.error();
  json rows = json::array();
  for (const database::Person& person : *people) {
    const auto record = training_record(call.store, call.site, person.id);
    if (!record) return record.error();
    rows.push_back(person_row_json(person, *record));
  }
  return json_response({{"people", rows}});
}

base::Result<Response> get_progress(Call& call) {
  const std::string& viewer_id = call.me().person.id;
  const std::string& named = call.parameter("id");
  const auto person = database::person_by_id(call.store, named == "me" ? viewer_id : named);
  if (!person) return person.error();
  const auto record = training_record(call.store, call.site, person->id);
  if (!record) return record.error();
  const auto bands = call.site.expert_bands.current(call.store);
  if (!bands) return bands.error();
  const auto exercises =
      exercises_progress_json(call.store, *record, *person, person->id == viewer_id, **bands);
  if (!exercises) return exercises.error();
  return json_response({{"person", person_row_json(*person, *record)}, {"exercises", *exercises}});
}

}  // namespace app
