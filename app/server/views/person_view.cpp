#include "app/server/views/person_view.h"

#include <optional>
#include <string>

#include "app/server/actor_names.h"
#include "app/server/training_record.h"
#include "app/server/views/progress_view.h"
#include "app/server/views/words.h"
#include "database/invitations.h"
#include "database/training_by.h"

namespace app {
namespace {

using nlohmann::json;

json or_null(const std::string& text) { return text.empty() ? json(nullptr) : json(text); }

json or_null(const std::optional<std::string>& text) { return text ? json(*text) : json(nullptr); }

base::Result<json> experience_json(database::Store& store, const std::string& person_id) {
  const auto experience = database::experience_of(store, person_id);
  if (!experience) return experience.error();
  const auto names = ActorNames::load(store);
  if (!names) return names.error();
  json rows = json::array();
  for (const database::Experience& one : *experience) {
    rows.push_back({{"level", database::word(one.level)},
                    {"cases", one.cases},
                    {"declared_utc", one.declared_utc},
                    {"declared_by", names->actor(one.declared_by)}});
  }
  return rows;
}

base::Result<json> memberships_json(database::Store& store, const std::string& person_id) {
  const auto memberships = database::memberships_of(store, person_id);
  if (!memberships) return memberships.error();
  json rows = json::array();
  for (const database::Membership& one : *memberships) {
    rows.push_back(
        {{"group", one.group}, {"from_utc", one.from_utc}, {"to_utc", or_null(one.to_utc)}});
  }
  return rows;
}

}  // namespace

base::Result<json> person_detail_json(database::Store& store, Site& site,
                                      const database::Person& person) {
  const auto record = training_record(store, site, person.id);
  if (!record) return record.error();
  const auto assigned = database::assigned_curriculum(store, person.id);
  if (!assigned) return assigned.error();
  const auto expires = database::invitation_expires(store, person.id);
  if (!expires) return expires.error();
  auto experience = experience_json(store, person.id);
  if (!experience) return experience.error();
  auto memberships = memberships_json(store, person.id);
  if (!memberships) return memberships.error();
  return json{{"person", person_row_json(person, *record)},
              {"email", person.email},
              {"curriculum_id", or_null(*assigned)},
              {"curriculum_title", english(record->curriculum->title)},
              {"experience", *std::move(experience)},
              {"memberships", *std::move(memberships)},
              {"invitation_expires_utc", or_null(*expires)},
              {"can_sign_in", person.can_sign_in()},
              {"last_sign_in_utc", or_null(person.last_sign_in_utc)},
              {"created_utc", person.created_utc}};
}

}  // namespace app
