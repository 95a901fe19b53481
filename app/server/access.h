// Whose data somebody may see: one's own; an instructor that of people in their groups, and of
// people who are published or simulated and so nobody's secret; an administrator everybody's.
#pragma once

#include <map>
#include <string>

#include "app/server/router.h"
#include "database/people.h"
#include "database/store.h"
#include "sim/base/result.h"

namespace app {

bool may_see(const database::Person& viewer, const database::Person& person);

// Looks up the person, trial or practice that the path names by {id} ("me": oneself). not_found
// when it does not exist, denied when it is somebody else's.
base::Status check_subject(database::Store& store, Site& site, const database::Person& viewer,
                           Subject subject, const std::map<std::string, std::string>& parameters);

}  // namespace app
