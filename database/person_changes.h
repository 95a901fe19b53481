// Changes to people as an administrator makes them: one by one, or many at once from a list. Each
// call happens whole or not at all.
//
// What holds for all of them: the last administrator who can sign in is neither disabled nor made
// something else; another role ends the person's sessions, and disabling also withdraws
// invitations; people who stand for simulated or published trials keep all but their groups.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/invitations.h"
#include "database/people.h"
#include "database/store.h"

namespace database {

// Only what is given changes.
struct PersonChange {
  std::optional<std::string> display_name, email;
  std::optional<Role> role;
  std::optional<bool> disabled;
  std::optional<std::vector<std::string>> groups;  // all of them; the others are left
  std::optional<Level> level;                      // declared today, with the cases so far
  std::optional<int> cases;
  std::optional<std::optional<std::string>> curriculum_id;  // none inside: the default of the site
};

// What is already so is not changed, declared or audited again. Fails with not_found, conflict
// (the rules above) or invalid_input.
base::Status change_person(Store& store, const std::string& person_id, const PersonChange& change,
                           const std::string& actor);

// One entry of a list: somebody new with a link, or a change to somebody.
struct ListedPerson {
  std::string person_id;  // empty: new
  NewPerson added;
  InvitationLink link;
  PersonChange change;
};

// All of them, in their order, or none. Gives the people's ids in the same order.
base::Result<std::vector<std::string>> take_in_people(Store& store,
                                                      const std::vector<ListedPerson>& list,
                                                      const std::string& actor);

}  // namespace database
