#include "database/settings.h"

#include "database/audit_chain.h"
#include "database/connection.h"
#include "database/text_limits.h"

namespace database {
namespace {

constexpr std::size_t kLongest = 16 * 1024;  // bytes

std::optional<std::string> load_setting(soci::session& sql, const std::string& person_id) {
  std::string value;
  sql << "SELECT value FROM person_setting WHERE person_id = :id", soci::use(person_id),
      soci::into(value);
  if (!sql.got_data()) return std::nullopt;
  return value;
}

}  // namespace

base::Result<std::optional<std::string>> person_setting(Store& store,
                                                        const std::string& person_id) {
  return reading(store, [&](soci::session& sql) -> base::Result<std::optional<std::string>> {
    return load_setting(sql, person_id);
  });
}

base::Status set_person_setting(Store& store, const std::string& person_id,
                                const std::string& json) {
  if (base::Status status = check_text("settings", json, kLongest); !status) return status;
  return writing(store, [&](soci::session& sql) -> base::Status {
    const std::optional<std::string> before = load_setting(sql, person_id);
    if (before == json) return base::Done{};
    execute(sql,
            "INSERT INTO person_setting (person_id, value, saved_utc) VALUES (:id, :value, :utc) "
            "ON CONFLICT (person_id) DO UPDATE SET value = excluded.value, "
            "saved_utc = excluded.saved_utc",
            person_id, json, utc_now());
    add_audit(sql,
              {person_id, "person.settings", "person:" + person_id,
               before ? hash_of({person_id, *before}) : std::string(), hash_of({person_id, json})});
    return base::Done{};
  });
}

}  // namespace database
