#include "database/training_by.h"

#include "database/audit_chain.h"
#include "database/connection.h"
#include "database/person_rows.h"
#include "database/text_limits.h"
#include "database/training_by_rows.h"

namespace database {
namespace {

using base::Error;
using base::ErrorCode;

const std::string kDefaultSetting = "default_curriculum";

Error nothing_published() {
  return {ErrorCode::not_found,
          "No curriculum is published yet; ask your administrator to publish one."};
}

base::Status check_published(soci::session& sql, const std::string& curriculum_id) {
  int versions = 0;
  sql << "SELECT count(*) FROM curriculum_version "
         "WHERE curriculum_id = :id AND status = 'published'",
      soci::use(curriculum_id), soci::into(versions);
  if (versions > 0) return base::Done{};
  return Error{ErrorCode::not_found, "No version of the curriculum '" + curriculum_id +
                                         "' is published: publish it "
                                         "first, or choose another."};
}

std::string load_setting(soci::session& sql) {
  std::string value;
  sql << "SELECT value FROM site_setting WHERE name = :name", soci::use(kDefaultSetting),
      soci::into(value);
  return sql.got_data() ? value : std::string();
}

std::optional<std::string> load_assignment(soci::session& sql, const std::string& person_id) {
  std::string id;
  sql << "SELECT curriculum_id FROM person_curriculum WHERE person_id = :person",
      soci::use(person_id), soci::into(id);
  if (!sql.got_data()) return std::nullopt;
  return id;
}

std::string hash_of_assignment(const std::string& person_id, const std::optional<std::string>& id) {
  return id ? hash_of({person_id, *id}) : std::string();
}

}  // namespace

std::optional<std::string> load_default_curriculum(soci::session& sql) {
  std::string chosen = load_setting(sql);
  if (!chosen.empty() && check_published(sql, chosen)) return chosen;
  std::string newest;
  sql << "SELECT curriculum_id FROM curriculum_version WHERE status = 'published' "
         "ORDER BY published_utc DESC, id DESC LIMIT 1",
      soci::into(newest);
  if (!sql.got_data()) return std::nullopt;
  return newest;
}

void store_default_curriculum(soci::session& sql, const std::string& curriculum_id,
                              const std::string& actor) {
  const std::string before = load_setting(sql);
  if (before == curriculum_id) return;
  execute(sql,
          "INSERT INTO site_setting (name, value) VALUES (:name, :value) "
          "ON CONFLICT (name) DO UPDATE SET value = excluded.value",
          kDefaultSetting, curriculum_id);
  add_audit(sql, {actor, "site.default_curriculum", "site_setting:" + kDefaultSetting,
                  before.empty() ? before : hash_of({before}), hash_of({curriculum_id})});
}

void fix_default_curriculum(soci::session& sql, const std::string& actor) {
  if (!load_setting(sql).empty()) return;
  if (const auto current = load_default_curriculum(sql)) {
    store_default_curriculum(sql, *current, actor);
  }
}

int assigned_to(soci::session& sql, const std::string& curriculum_id) {
  int people = 0;
  sql << "SELECT count(*) FROM person_curriculum WHERE curriculum_id = :id",
      soci::use(curriculum_id), soci::into(people);
  return people;
}

base::Status change_assignment(soci::session& sql, const std::string& person_id,
                               const std::optional<std::string>& curriculum_id,
                               const std::string& actor) {
  const std::optional<std::string> before = load_assignment(sql, person_id);
  if (before == curriculum_id) return base::Done{};
  if (curriculum_id) {
    if (base::Status status = check_published(sql, *curriculum_id); !status) return status;
    execute(sql,
            "INSERT INTO person_curriculum (person_id, curriculum_id, assigned_utc, assigned_by) "
            "VALUES (:person, :curriculum, :utc, :by) ON CONFLICT (person_id) DO UPDATE SET "
            "curriculum_id = excluded.curriculum_id, assigned_utc = excluded.assigned_utc, "
            "assigned_by = excluded.assigned_by",
            person_id, *curriculum_id, utc_now(), actor);
  } else {
    execute(sql, "DELETE FROM person_curriculum WHERE person_id = :person", person_id);
  }
  add_audit(sql,
            {actor, "person.curriculum", "person:" + person_id,
             hash_of_assignment(person_id, before), hash_of_assignment(person_id, curriculum_id)});
  return base::Done{};
}

base::Status assign_curriculum(Store& store, const std::string& person_id,
                               const std::optional<std::string>& curriculum_id,
                               const std::string& actor) {
  if (base::Status status = check_name("actor", actor); !status) return status;
  if (curriculum_id) {
    if (base::Status status = check_name("id of the curriculum", *curriculum_id); !status) {
      return status;
    }
  }
  return writing(store, [&](soci::session& sql) -> base::Status {
    if (const auto person = load_person(sql, person_id); !person) return person.error();
    return change_assignment(sql, person_id, curriculum_id, actor);
  });
}

base::Result<std::optional<std::string>> assigned_curriculum(Store& store,
                                                             const std::string& person_id) {
  return reading(store, [&](soci::session& sql) -> base::Result<std::optional<std::string>> {
    if (const auto person = load_person(sql, person_id); !person) return person.error();
    return load_assignment(sql, person_id);
  });
}

base::Result<std::map<std::string, std::string>> assigned_curricula(Store& store) {
  return reading(store, [](soci::session& sql) -> base::Result<std::map<std::string, std::string>> {
    std::map<std::string, std::string> assigned;
    std::string person, curriculum;
    soci::statement select =
        (sql.prepare << "SELECT person_id, curriculum_id FROM person_curriculum",
         soci::into(person), soci::into(curriculum));
    select.execute();
    while (select.fetch()) assigned.emplace(person, curriculum);
    return assigned;
  });
}

base::Result<std::string> curriculum_of(Store& store, const std::string& person_id) {
  return reading(store, [&](soci::session& sql) -> base::Result<std::string> {
    if (const auto assigned = load_assignment(sql, person_id)) return *assigned;
    if (const auto person = load_person(sql, person_id); !person) return person.error();
    const auto standard = load_default_curriculum(sql);
    if (!standard) return nothing_published();
    return *standard;
  });
}

base::Result<std::string> default_curriculum(Store& store) {
  return reading(store, [](soci::session& sql) -> base::Result<std::string> {
    const auto standard = load_default_curriculum(sql);
    if (!standard) return nothing_published();
    return *standard;
  });
}

base::Status set_default_curriculum(Store& store, const std::string& curriculum_id,
                                    const std::string& actor) {
  if (base::Status status = check_name("actor", actor); !status) return status;
  if (base::Status status = check_name("id of the curriculum", curriculum_id); !status) {
    return status;
  }
  return writing(store, [&](soci::session& sql) -> base::Status {
    if (base::Status status = check_published(sql, curriculum_id); !status) return status;
    store_default_curriculum(sql, curriculum_id, actor);
    return base::Done{};
  });
}

}  // namespace database
