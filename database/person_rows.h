// Reads and audits people inside a transaction. For database/*.cpp only.
#pragma once

#include <string>
#include <vector>

#include <soci/soci.h>

#include "database/people.h"

namespace database {

// People with groups and level, by name. `condition` is on p (person) and i (identity) and holds
// the parameter :value once. Three queries, however many people.
std::vector<Person> load_people(soci::session& sql, const std::string& condition,
                                const std::string& value);

base::Result<Person> load_person(soci::session& sql, const std::string& id);  // not_found

// The hash of all that is stored about a person, for the audit.
std::string hash_of_person(soci::session& sql, const Person& person);

// Changes one person and audits it: `change` runs between the hash before and the hash after.
template <typename Change>
base::Status change_person(soci::session& sql, const std::string& id, const std::string& actor,
                           const char* action, Change change);

// Checks a new person's values and whether the name is free, adds the person and audits it; gives
// the id. `actor` has been checked.
base::Result<std::string> insert_new_person(soci::session& sql, const NewPerson& person,
                                            const std::string& actor);

// In groups.cpp and experience.cpp; the caller has checked the values.
void insert_membership(soci::session& sql, const std::string& person_id, const std::string& group);
void end_membership(soci::session& sql, const std::string& person_id, const std::string& group);
void insert_experience(soci::session& sql, const std::string& person_id, Level level, int cases,
                       const std::string& declared_utc, const std::string& declared_by);

// The number of cases that was declared last; 0 when none was.
int latest_cases(soci::session& sql, const std::string& person_id);

// Ends what would let the person in. In sign_in.cpp and invitations.cpp.
void end_sessions(soci::session& sql, const std::string& person_id,
                  const std::string& kept_hash = "");
void withdraw_invitations(soci::session& sql, const std::string& person_id);

// Writes the audit row of a change to a person that has already been made.
void audit_person(soci::session& sql, const std::string& id, const std::string& actor,
                  const char* action, const std::string& before_hash);

template <typename Change>
base::Status change_person(soci::session& sql, const std::string& id, const std::string& actor,
                           const char* action, Change change) {
  const base::Result<Person> person = load_person(sql, id);
  if (!person) return person.error();
  const std::string before_hash = hash_of_person(sql, *person);
  change();
  audit_person(sql, id, actor, action, before_hash);
  return base::Done{};
}

}  // namespace database
