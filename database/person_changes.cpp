#include "database/person_changes.h"

#include <algorithm>

#include "database/connection.h"
#include "database/invitation_rows.h"
#include "database/person_rows.h"
#include "database/text_limits.h"
#include "database/training_by_rows.h"

namespace database {
namespace {

using base::Error;
using base::ErrorCode;

base::Status check_values(const PersonChange& change) {
  if (change.display_name) {
    if (base::Status status = check_name("display name", *change.display_name); !status) {
      return status;
    }
  }
  if (change.email) {
    if (base::Status status = check_email(*change.email); !status) return status;
  }
  if (change.groups) {
    for (const std::string& group : *change.groups) {
      if (base::Status status = check_name("name of the group", group); !status) return status;
    }
  }
  if (change.cases && *change.cases < 0) {
    return Error{ErrorCode::invalid_input, "The number of cases is 0 or more."};
  }
  return base::Done{};
}

bool changes_more_than_groups(const PersonChange& change) {
  return change.display_name || change.email || change.role || change.disabled || change.level ||
         change.cases || change.curriculum_id;
}

bool is_last_administrator(soci::session& sql, const Person& person) {
  if (person.role != Role::administrator || !person.can_sign_in()) return false;
  int others = 0;
  sql << "SELECT count(*) FROM identity i JOIN person p ON p.id = i.person_id "
         "WHERE i.role = 'administrator' AND i.disabled = 0 AND i.password_phc <> '' "
         "AND p.kind = 'live' AND p.id <> :id",
      soci::use(person.id), soci::into(others);
  return others == 0;
}

base::Status check_allowed(soci::session& sql, const Person& person, const PersonChange& change) {
  if (person.kind != PersonKind::live && changes_more_than_groups(change)) {
    return Error{ErrorCode::conflict, person.display_name + " stands for " + word(person.kind) +
                                          " trials: only the groups can be changed."};
  }
  const bool shut_out = change.disabled.value_or(false) ||
                        change.role.value_or(Role::administrator) != Role::administrator;
  if (shut_out && is_last_administrator(sql, person)) {
    return Error{ErrorCode::conflict,
                 person.display_name +
                     " is the last administrator who can sign in; make somebody else an "
                     "administrator first."};
  }
  if (change.cases && !change.level && !person.level) {
    return Error{ErrorCode::invalid_input,
                 "Give the level of experience together with the number of cases."};
  }
  return base::Done{};
}

void set_column(soci::session& sql, const std::string& id, const char* column,
                const std::string& value) {
  execute(sql, std::string("UPDATE identity SET ") + column + " = :value WHERE person_id = :id",
          value, id);
}

void change_identity(soci::session& sql, const Person& person, const PersonChange& change) {
  if (change.display_name) set_column(sql, person.id, "display_name", *change.display_name);
  if (change.email) {
    execute(sql, "UPDATE identity SET email = nullif(:email, '') WHERE person_id = :id",
            *change.email, person.id);
  }
  if (change.role && *change.role != person.role) {
    set_column(sql, person.id, "role", word(*change.role));
    end_sessions(sql, person.id);
  }
  if (change.disabled) {
    execute(sql, "UPDATE identity SET disabled = :disabled WHERE person_id = :id",
            *change.disabled ? 1 : 0, person.id);
    if (*change.disabled) {
      end_sessions(sql, person.id);
      withdraw_invitations(sql, person.id);
    }
  }
}

void change_groups(soci::session& sql, const Person& person,
                   const std::vector<std::string>& wanted) {
  const auto within = [](const std::vector<std::string>& groups, const std::string& group) {
    return std::find(groups.begin(), groups.end(), group) != groups.end();
  };
  for (const std::string& group : person.groups) {
    if (!within(wanted, group)) end_membership(sql, person.id, group);
  }
  for (const std::string& group : wanted) {
    if (!within(person.groups, group)) insert_membership(sql, person.id, group);
  }
}

// True when it declared something.
bool change_experience(soci::session& sql, const Person& person, const PersonChange& change,
                       const std::string& actor) {
  if (!change.level && !change.cases) return false;
  const Level level = change.level ? *change.level : *person.level;
  const int known = latest_cases(sql, person.id);
  const int cases = change.cases.value_or(known);
  if (person.level && *person.level == level && known == cases) return false;
  insert_experience(sql, person.id, level, cases, utc_now(), actor);
  return true;
}

// What the change is called in the audit.
const char* action_of(const Person& person, const PersonChange& change) {
  if (change.disabled && *change.disabled != person.disabled) {
    return *change.disabled ? "person.disable" : "person.enable";
  }
  if (change.role && *change.role != person.role) return "person.role";
  return "person.change";
}

base::Status apply_change(soci::session& sql, const std::string& id, const PersonChange& change,
                          const std::string& actor) {
  if (base::Status status = check_values(change); !status) return status;
  const base::Result<Person> person = load_person(sql, id);
  if (!person) return person.error();
  if (base::Status status = check_allowed(sql, *person, change); !status) return status;
  const std::string before = hash_of_person(sql, *person);
  change_identity(sql, *person, change);
  if (change.groups) change_groups(sql, *person, *change.groups);
  const bool declared = change_experience(sql, *person, change, actor);
  const base::Result<Person> after = load_person(sql, id);
  if (!after) return after.error();
  if (declared || hash_of_person(sql, *after) != before) {
    audit_person(sql, id, actor, action_of(*person, change), before);
  }
  if (!change.curriculum_id) return base::Done{};
  return change_assignment(sql, id, *change.curriculum_id, actor);
}

base::Result<std::string> take_in(soci::session& sql, const ListedPerson& listed,
                                  const std::string& actor) {
  if (!listed.person_id.empty()) {
    const base::Status changed = apply_change(sql, listed.person_id, listed.change, actor);
    if (!changed) return changed.error();
    return listed.person_id;
  }
  const base::Result<std::string> id = insert_new_person(sql, listed.added, actor);
  if (!id) return id.error();
  const base::Result<Person> added = load_person(sql, *id);
  if (!added) return added.error();
  const base::Status invited = insert_invitation(sql, *added, listed.link, actor);
  if (!invited) return invited.error();
  return *id;
}

}  // namespace

base::Status change_person(Store& store, const std::string& person_id, const PersonChange& change,
                           const std::string& actor) {
  if (base::Status status = check_name("actor", actor); !status) return status;
  return writing(store,
                 [&](soci::session& sql) { return apply_change(sql, person_id, change, actor); });
}

base::Result<std::vector<std::string>> take_in_people(Store& store,
                                                      const std::vector<ListedPerson>& list,
                                                      const std::string& actor) {
  if (base::Status status = check_name("actor", actor); !status) return status.error();
  return writing(store, [&](soci::session& sql) -> base::Result<std::vector<std::string>> {
    std::vector<std::string> ids;
    for (const ListedPerson& listed : list) {
      const base::Result<std::string> id = take_in(sql, listed, actor);
      if (!id) {
        const std::string& name = listed.person_id.empty() ? listed.added.name : listed.person_id;
        return Error{id.error().code, name + ": " + id.error().message};
      }
      ids.push_back(*id);
    }
    return ids;
  });
}

}  // namespace database
