#include "database/connection.h"
#include "database/people.h"
#include "database/person_rows.h"
#include "database/text_limits.h"
#include "database/utc.h"

namespace database {

void insert_experience(soci::session& sql, const std::string& person_id, Level level, int cases,
                       const std::string& declared_utc, const std::string& declared_by) {
  int ordinal = 0;
  sql << "SELECT coalesce(max(ordinal), 0) + 1 FROM experience WHERE person_id = :id",
      soci::use(person_id), soci::into(ordinal);
  execute(sql,
          "INSERT INTO experience (person_id, ordinal, level, cases, declared_utc, declared_by) "
          "VALUES (:person, :ordinal, :level, :cases, :utc, :by)",
          person_id, ordinal, std::string(word(level)), cases, declared_utc, declared_by);
}

int latest_cases(soci::session& sql, const std::string& person_id) {
  int cases = 0;
  sql << "SELECT cases FROM experience WHERE person_id = :id "
         "ORDER BY declared_utc DESC, ordinal DESC LIMIT 1",
      soci::use(person_id), soci::into(cases);
  return sql.got_data() ? cases : 0;
}

base::Result<std::vector<Experience>> experience_of(Store& store, const std::string& person_id) {
  return reading(store, [&](soci::session& sql) -> base::Result<std::vector<Experience>> {
    std::vector<Experience> all;
    Experience one;
    std::string level;
    soci::statement select =
        (sql.prepare << "SELECT level, cases, declared_utc, declared_by FROM experience "
                        "WHERE person_id = :id ORDER BY declared_utc DESC, ordinal DESC",
         soci::use(person_id), soci::into(level), soci::into(one.cases),
         soci::into(one.declared_utc), soci::into(one.declared_by));
    select.execute();
    while (select.fetch()) {
      parse(level, one.level);
      all.push_back(one);
    }
    return all;
  });
}

base::Result<std::map<std::string, int>> cases_by_person(Store& store) {
  return reading(store, [](soci::session& sql) -> base::Result<std::map<std::string, int>> {
    std::map<std::string, int> all;
    std::string person_id;
    int cases = 0;
    soci::statement select = (sql.prepare << "SELECT person_id, cases FROM experience "
                                             "ORDER BY person_id, declared_utc, ordinal",
                              soci::into(person_id), soci::into(cases));
    select.execute();
    while (select.fetch()) all[person_id] = cases;  // the latest comes last and stays
    return all;
  });
}

base::Status declare_experience(Store& store, const std::string& person_id, Level level, int cases,
                                const std::string& actor, const std::string& declared_utc) {
  if (base::Status status = check_name("actor", actor); !status) return status;
  if (cases < 0) {
    return base::Error{base::ErrorCode::invalid_input, "The number of cases is 0 or more."};
  }
  const base::Result<std::string> utc = stored_utc(declared_utc);
  if (!utc) return utc.error();
  return writing(store, [&](soci::session& sql) {
    return change_person(sql, person_id, actor, "person.experience",
                         [&] { insert_experience(sql, person_id, level, cases, *utc, actor); });
  });
}

base::Result<std::optional<Level>> level_at(Store& store, const std::string& person_id,
                                            const std::string& utc) {
  const base::Result<std::string> moment = stored_utc(utc);
  if (!moment) return moment.error();
  return reading(store, [&](soci::session& sql) -> base::Result<std::optional<Level>> {
    if (const auto person = load_person(sql, person_id); !person) return person.error();
    std::string text;
    sql << "SELECT level FROM experience WHERE person_id = :id AND declared_utc <= :utc "
           "ORDER BY declared_utc DESC, ordinal DESC LIMIT 1",
        soci::use(person_id), soci::use(*moment), soci::into(text);
    std::optional<Level> level;
    Level parsed = Level::novice;
    if (sql.got_data() && parse(text, parsed)) level = parsed;
    return level;
  });
}

}  // namespace database
