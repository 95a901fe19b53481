#include "database/people.h"

#include <array>
#include <unordered_map>
#include <utility>

#include "database/audit_chain.h"
#include "database/connection.h"
#include "database/person_rows.h"
#include "database/text_limits.h"
#include "database/training_by_rows.h"
#include "database/utc.h"

namespace database {
namespace {

using base::Error;
using base::ErrorCode;

constexpr std::array kRoles = {Role::trainee, Role::instructor, Role::administrator,
                               Role::researcher};
constexpr std::array kLevels = {Level::novice, Level::intermediate, Level::expert};
constexpr std::array kKinds = {PersonKind::live, PersonKind::simulated, PersonKind::published};

template <typename Value, std::size_t count>
bool parse_word(const std::string& text, const std::array<Value, count>& values, Value& result) {
  for (const Value value : values) {
    if (text == word(value)) {
      result = value;
      return true;
    }
  }
  return false;
}

constexpr const char* kFromPeople = " FROM person p JOIN identity i ON i.person_id = p.id ";

Error unknown_person() { return {ErrorCode::not_found, "There is no such person."}; }

base::Status check_new_person(const NewPerson& person) {
  if (base::Status status = check_name("name", person.name); !status) return status;
  if (!person.display_name.empty()) {
    if (base::Status status = check_name("display name", person.display_name); !status) {
      return status;
    }
  }
  for (const std::string& group : person.groups) {
    if (base::Status status = check_name("name of the group", group); !status) return status;
  }
  if (base::Status status = check_email(person.email); !status) return status;
  if (person.cases < 0) {
    return Error{ErrorCode::invalid_input, "The number of cases is 0 or more."};
  }
  if (person.curriculum_id) {
    if (base::Status status = check_name("id of the curriculum", *person.curriculum_id); !status) {
      return status;
    }
  }
  return check_text("password hash", person.password_phc);
}

// When the level given with a new person was declared.
base::Result<std::string> declaring_utc(const NewPerson& person) {
  if (person.kind == PersonKind::live || !person.level_declared_utc.empty()) {
    return stored_utc(person.level_declared_utc);
  }
  return std::string(kAlwaysUtc);
}

void insert_person(soci::session& sql, const NewPerson& person, const std::string& id) {
  const std::string& display_name = person.display_name.empty() ? person.name : person.display_name;
  execute(sql, "INSERT INTO person (id, kind, created_utc) VALUES (:id, :kind, :utc)", id,
          std::string(word(person.kind)), utc_now());
  execute(
      sql,
      "INSERT INTO identity (person_id, name, display_name, email, password_phc, role, disabled, "
      "salt) VALUES (:id, :name, :display, nullif(:email, ''), :phc, :role, 0, :salt)",
      id, person.name, display_name, person.email, person.password_phc,
      std::string(word(person.role)), new_id());
}

std::unordered_map<std::string, std::size_t> index_by_id(const std::vector<Person>& people) {
  std::unordered_map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < people.size(); ++i) index.emplace(people[i].id, i);
  return index;
}

// Runs a query that gives (person id, text) and hands each pair to `take` with its person.
template <typename Take>
void for_each_text_of(soci::session& sql, const std::string& query, const std::string& value,
                      std::vector<Person>& people, Take take) {
  const std::unordered_map<std::string, std::size_t> index = index_by_id(people);
  std::string person_id, text;
  soci::statement select =
      (sql.prepare << query, soci::use(value), soci::into(person_id), soci::into(text));
  select.execute();
  while (select.fetch()) {
    const auto found = index.find(person_id);
    if (found != index.end()) take(people[found->second], text);
  }
}

base::Result<Person> only(std::vector<Person> people) {
  if (people.empty()) return unknown_person();
  return std::move(people.front());
}

}  // namespace

const char* word(Role role) {
  switch (role) {
    case Role::trainee:
      return "trainee";
    case Role::instructor:
      return "instructor";
    case Role::administrator:
      return "administrator";
    case Role::researcher:
      return "researcher";
  }
  return "";
}

const char* word(Level level) {
  switch (level) {
    case Level::novice:
      return "novice";
    case Level::intermediate:
      return "intermediate";
    case Level::expert:
      return "expert";
  }
  return "";
}

const char* word(PersonKind kind) {
  switch (kind) {
    case PersonKind::live:
      return "live";
    case PersonKind::simulated:
      return "simulated";
    case PersonKind::published:
      return "published";
  }
  return "";
}

bool parse(const std::string& text, Role& role) { return parse_word(text, kRoles, role); }
bool parse(const std::string& text, Level& level) { return parse_word(text, kLevels, level); }
bool parse(const std::string& text, PersonKind& kind) { return parse_word(text, kKinds, kind); }

std::vector<Person> load_people(soci::session& sql, const std::string& condition,
                                const std::string& value) {
  std::vector<Person> people;
  Person person;
  std::string role, kind;
  int disabled = 0;
  soci::statement select =
      (sql.prepare << "SELECT p.id, i.name, i.display_name, i.role, p.kind, i.disabled, "
                      "i.password_phc, p.created_utc, coalesce(i.email, ''), "
                      "coalesce(i.last_sign_in_utc, '')" +
                          (kFromPeople + ("WHERE " + condition)) + " ORDER BY lower(i.name), p.id",
       soci::use(value), soci::into(person.id), soci::into(person.name),
       soci::into(person.display_name), soci::into(role), soci::into(kind), soci::into(disabled),
       soci::into(person.password_phc), soci::into(person.created_utc), soci::into(person.email),
       soci::into(person.last_sign_in_utc));
  select.execute();
  while (select.fetch()) {
    parse(role, person.role);
    parse(kind, person.kind);
    person.disabled = disabled != 0;
    people.push_back(person);
  }

  for_each_text_of(sql,
                   "SELECT p.id, g.name" + std::string(kFromPeople) +
                       "JOIN membership m ON m.person_id = p.id AND m.to_utc IS NULL "
                       "JOIN person_group g ON g.id = m.group_id WHERE " +
                       condition + " ORDER BY p.id, g.name",
                   value, people,
                   [](Person& of, const std::string& group) { of.groups.push_back(group); });
  // the latest comes last and stays
  for_each_text_of(sql,
                   "SELECT p.id, e.level" + std::string(kFromPeople) +
                       "JOIN experience e ON e.person_id = p.id WHERE " + condition +
                       " ORDER BY p.id, e.declared_utc, e.ordinal",
                   value, people, [](Person& of, const std::string& text) {
                     Level level = Level::novice;
                     if (parse(text, level)) of.level = level;
                   });
  return people;
}

base::Result<Person> load_person(soci::session& sql, const std::string& id) {
  return only(load_people(sql, "p.id = :value", id));
}

std::string hash_of_person(soci::session& sql, const Person& person) {
  std::string salt;
  sql << "SELECT salt FROM identity WHERE person_id = :id", soci::use(person.id), soci::into(salt);
  std::vector<std::string> fields = {salt,
                                     person.id,
                                     person.name,
                                     person.display_name,
                                     word(person.role),
                                     word(person.kind),
                                     person.disabled ? "disabled" : "enabled",
                                     person.password_phc,
                                     person.level ? word(*person.level) : ""};
  fields.insert(fields.end(), person.groups.begin(), person.groups.end());
  // only when there is one: the hashes of people without stay what they were before e-mail came
  if (!person.email.empty()) fields.push_back("e-mail " + person.email);
  return hash_of(fields);
}

void audit_person(soci::session& sql, const std::string& id, const std::string& actor,
                  const char* action, const std::string& before_hash) {
  const base::Result<Person> after = load_person(sql, id);
  add_audit(sql, {actor, action, "person:" + id, before_hash,
                  after ? hash_of_person(sql, *after) : std::string()});
}

base::Result<std::string> insert_new_person(soci::session& sql, const NewPerson& person,
                                            const std::string& actor) {
  if (base::Status status = check_new_person(person); !status) return status.error();
  const base::Result<std::string> declared_utc = declaring_utc(person);
  if (!declared_utc) return declared_utc.error();
  int taken = 0;
  sql << "SELECT count(*) FROM identity WHERE lower(name) = lower(:name)", soci::use(person.name),
      soci::into(taken);
  if (taken > 0) {
    return Error{ErrorCode::conflict, "The name " + person.name + " is taken; choose another."};
  }
  const std::string id = new_id();
  insert_person(sql, person, id);
  for (const std::string& group : person.groups) insert_membership(sql, id, group);
  if (person.level) {
    insert_experience(sql, id, *person.level, person.cases, *declared_utc, actor);
  }
  audit_person(sql, id, actor, "person.add", "");
  if (person.curriculum_id) {
    const base::Status assigned = change_assignment(sql, id, person.curriculum_id, actor);
    if (!assigned) return assigned.error();
  }
  return id;
}

base::Result<Person> add_person(Store& store, const NewPerson& person, const std::string& actor) {
  if (base::Status status = check_name("actor", actor); !status) return status.error();
  return writing(store, [&](soci::session& sql) -> base::Result<Person> {
    const base::Result<std::string> id = insert_new_person(sql, person, actor);
    if (!id) return id.error();
    return load_person(sql, *id);
  });
}

base::Result<Person> person_by_id(Store& store, const std::string& id) {
  return reading(store, [&](soci::session& sql) { return load_person(sql, id); });
}

base::Result<Person> person_by_name(Store& store, const std::string& name) {
  return reading(store, [&](soci::session& sql) {
    return only(load_people(sql, "lower(i.name) = lower(:value)", name));
  });
}

base::Result<std::vector<Person>> people(Store& store) {
  return reading(store, [](soci::session& sql) -> base::Result<std::vector<Person>> {
    return load_people(sql, ":value = ''", "");
  });
}

base::Result<std::vector<Person>> people_of_instructor(Store& store,
                                                       const std::string& instructor_id) {
  return reading(store, [&](soci::session& sql) -> base::Result<std::vector<Person>> {
    if (const auto instructor = load_person(sql, instructor_id); !instructor) {
      return instructor.error();
    }
    std::vector<Person> shown = load_people(
        sql,
        "p.id IN (SELECT theirs.person_id FROM membership own "
        "JOIN membership theirs ON theirs.group_id = own.group_id "
        "WHERE own.person_id = :value AND own.to_utc IS NULL AND theirs.to_utc IS NULL)",
        instructor_id);
    std::erase_if(shown, [&](const Person& person) { return person.id == instructor_id; });
    return shown;
  });
}

base::Status set_disabled(Store& store, const std::string& person_id, bool disabled,
                          const std::string& actor) {
  if (base::Status status = check_name("actor", actor); !status) return status;
  return writing(store, [&](soci::session& sql) {
    return change_person(sql, person_id, actor, disabled ? "person.disable" : "person.enable", [&] {
      execute(sql, "UPDATE identity SET disabled = :disabled WHERE person_id = :id",
              disabled ? 1 : 0, person_id);
      if (disabled) {
        end_sessions(sql, person_id);
        withdraw_invitations(sql, person_id);
      }
    });
  });
}

base::Status set_password(Store& store, const std::string& person_id, const std::string& phc,
                          const std::string& actor) {
  if (base::Status status = check_text("password hash", phc); !status) return status;
  if (base::Status status = check_name("actor", actor); !status) return status;
  return writing(store, [&](soci::session& sql) {
    return change_person(sql, person_id, actor, "person.password", [&] {
      execute(sql, "UPDATE identity SET password_phc = :phc WHERE person_id = :id", phc, person_id);
    });
  });
}

}  // namespace database
