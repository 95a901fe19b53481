// One person, for administrators: inviting, changing, a new link; and the groups there are.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/server/invitation_link.h"
#include "app/server/json_body.h"
#include "app/server/json_fields.h"
#include "app/server/routes/handlers.h"
#include "app/server/site.h"
#include "app/server/views/person_view.h"
#include "database/person_changes.h"

namespace app {
namespace {

using nlohmann::json;

constexpr int kManyCases = 1000000;

std::optional<database::Level> read_level(JsonFields& fields) {
  database::Level level{};
  return database::parse(fields.one_of("level", {"novice", "intermediate", "expert"}), level)
             ? std::optional(level)
             : std::nullopt;
}

database::Role read_role(JsonFields& fields) {
  database::Role role{};
  database::parse(fields.one_of("role", {"trainee", "instructor", "administrator", "researcher"}),
                  role);
  return role;
}

base::Result<database::NewPerson> read_new_person(const json& body) {
  JsonFields fields(body);
  database::NewPerson person;
  person.name = fields.text("name");
  person.display_name = fields.text("display_name");
  person.email = fields.text("email");
  person.role = read_role(fields);
  if (fields.text_or_null("level")) person.level = read_level(fields);
  person.cases = fields.whole("cases", 0, kManyCases);
  person.groups = fields.texts("groups");
  person.curriculum_id = fields.text_or_null("curriculum_id");
  if (person.cases > 0 && !person.level) {
    fields.fail("Give the level of experience together with the number of cases.");
  }
  if (const auto read = fields.done(); !read) return read.error();
  return person;
}

base::Result<database::PersonChange> read_change(const json& body) {
  JsonFields fields(body);
  database::PersonChange change;
  if (fields.has("display_name")) change.display_name = fields.text("display_name");
  if (fields.has("email")) change.email = fields.text("email");
  if (fields.has("role")) change.role = read_role(fields);
  if (fields.has("disabled")) change.disabled = fields.truth("disabled");
  if (fields.has("groups")) change.groups = fields.texts("groups");
  if (fields.has("level")) change.level = read_level(fields);
  if (fields.has("cases")) change.cases = fields.whole("cases", 0, kManyCases);
  if (fields.has("curriculum_id")) change.curriculum_id = fields.text_or_null("curriculum_id");
  if (const auto read = fields.done(); !read) return read.error();
  return change;
}

base::Result<Response> detail_response(Call& call, const std::string& person_id) {
  const auto person = database::person_by_id(call.store, person_id);
  if (!person) return person.error();
  const auto detail = person_detail_json(call.store, call.site, *person);
  if (!detail) return detail.error();
  return json_response(*detail);
}

// "me" is a name for oneself in every path about a person.
const std::string& named_person(const Call& call) {
  const std::string& id = call.parameter("id");
  return id == "me" ? call.me().person.id : id;
}

}  // namespace

base::Result<Response> get_person(Call& call) { return detail_response(call, named_person(call)); }

base::Result<Response> post_person(Call& call) {
  const auto body = read_json_object(call.request);
  if (!body) return body.error();
  const auto person = read_new_person(*body);
  if (!person) return person.error();
  const NewInvitation invitation = new_invitation();
  const auto added =
      database::invite_person(call.store, *person, invitation.link, call.me().person.id);
  if (!added) return added.error();
  return json_response(invitation_json(*added, invitation), 201);
}

base::Result<Response> put_person(Call& call) {
  const auto body = read_json_object(call.request);
  if (!body) return body.error();
  const auto change = read_change(*body);
  if (!change) return change.error();
  const std::string& id = named_person(call);
  const auto changed = database::change_person(call.store, id, *change, call.me().person.id);
  if (!changed) return changed.error();
  return detail_response(call, id);
}

base::Result<Response> post_person_invitation(Call& call) {
  const auto person = database::person_by_id(call.store, named_person(call));
  if (!person) return person.error();
  const NewInvitation invitation = new_invitation();
  const auto added =
      database::add_invitation(call.store, person->id, invitation.link, call.me().person.id);
  if (!added) return added.error();
  return json_response(invitation_json(*person, invitation), 201);
}

base::Result<Response> get_groups(Call& call) {
  const auto groups = database::groups(call.store);
  if (!groups) return groups.error();
  const database::Person& viewer = call.me().person;
  json rows = json::array();
  for (const database::Group& group : *groups) {
    const bool own =
        std::find(viewer.groups.begin(), viewer.groups.end(), group.name) != viewer.groups.end();
    if (!own && viewer.role != database::Role::administrator) continue;
    rows.push_back({{"name", group.name}, {"people", group.people}});
  }
  return json_response({{"groups", rows}});
}

}  // namespace app
