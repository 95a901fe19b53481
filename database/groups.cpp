#include "database/connection.h"
#include "database/people.h"
#include "database/person_rows.h"
#include "database/text_limits.h"

namespace database {
namespace {

std::string group_id(soci::session& sql, const std::string& name) {
  std::string id;
  sql << "SELECT id FROM person_group WHERE name = :name", soci::use(name), soci::into(id);
  if (sql.got_data()) return id;
  id = new_id();
  execute(sql, "INSERT INTO person_group (id, name, created_utc) VALUES (:id, :name, :utc)", id,
          name, utc_now());
  return id;
}

base::Status check_names(const std::string& group, const std::string& actor) {
  if (base::Status status = check_name("name of the group", group); !status) return status;
  return check_name("actor", actor);
}

}  // namespace

void insert_membership(soci::session& sql, const std::string& person_id, const std::string& group) {
  const std::string id = group_id(sql, group);
  int already = 0;
  sql << "SELECT count(*) FROM membership WHERE person_id = :person AND group_id = :id "
         "AND to_utc IS NULL",
      soci::use(person_id), soci::use(id), soci::into(already);
  if (already > 0) return;
  execute(sql,
          "INSERT INTO membership (id, person_id, group_id, from_utc) "
          "VALUES (:id, :person, :group_id, :utc)",
          new_id(), person_id, id, utc_now());
}

void end_membership(soci::session& sql, const std::string& person_id, const std::string& group) {
  execute(sql,
          "UPDATE membership SET to_utc = :utc WHERE person_id = :person AND to_utc IS NULL "
          "AND group_id IN (SELECT id FROM person_group WHERE name = :name)",
          utc_now(), person_id, group);
}

base::Status join_group(Store& store, const std::string& person_id, const std::string& group,
                        const std::string& actor) {
  if (base::Status status = check_names(group, actor); !status) return status;
  return writing(store, [&](soci::session& sql) {
    return change_person(sql, person_id, actor, "person.join_group",
                         [&] { insert_membership(sql, person_id, group); });
  });
}

base::Status leave_group(Store& store, const std::string& person_id, const std::string& group,
                         const std::string& actor) {
  if (base::Status status = check_names(group, actor); !status) return status;
  return writing(store, [&](soci::session& sql) {
    return change_person(sql, person_id, actor, "person.leave_group",
                         [&] { end_membership(sql, person_id, group); });
  });
}

base::Result<std::vector<Membership>> memberships_of(Store& store, const std::string& person_id) {
  return reading(store, [&](soci::session& sql) -> base::Result<std::vector<Membership>> {
    std::vector<Membership> memberships;
    Membership membership;
    soci::statement select =
        (sql.prepare << "SELECT g.name, m.from_utc, coalesce(m.to_utc, '') FROM membership m "
                        "JOIN person_group g ON g.id = m.group_id WHERE m.person_id = :id "
                        "ORDER BY m.from_utc DESC, g.name",
         soci::use(person_id), soci::into(membership.group), soci::into(membership.from_utc),
         soci::into(membership.to_utc));
    select.execute();
    while (select.fetch()) memberships.push_back(membership);
    return memberships;
  });
}

base::Result<std::vector<Group>> groups(Store& store) {
  return reading(store, [](soci::session& sql) -> base::Result<std::vector<Group>> {
    std::vector<Group> all;
    Group group;
    soci::statement select =
        (sql.prepare << "SELECT g.name, count(m.id) FROM person_group g LEFT JOIN membership m "
                        "ON m.group_id = g.id AND m.to_utc IS NULL GROUP BY g.id ORDER BY g.name",
         soci::into(group.name), soci::into(group.people));
    select.execute();
    while (select.fetch()) all.push_back(group);
    return all;
  });
}

}  // namespace database
