// Who trains by which curriculum: the one assigned to the person, else the default of the site.
//
// The default is what an administrator chose; before anybody chose, the curriculum published last.
// Publishing a second curriculum fixes the default as it was (curricula.h), so that nobody's
// training changes because somebody published something.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "database/store.h"

namespace database {

// Null: the default again. not_found: the person, or no published version of the curriculum.
// Assigning what is assigned already changes nothing and is not audited.
base::Status assign_curriculum(Store& store, const std::string& person_id,
                               const std::optional<std::string>& curriculum_id,
                               const std::string& actor);
// What was assigned to the person; null: the default. not_found: the person.
base::Result<std::optional<std::string>> assigned_curriculum(Store& store,
                                                             const std::string& person_id);
// Person -> curriculum, of all who are assigned one. For lists: one query.
base::Result<std::map<std::string, std::string>> assigned_curricula(Store& store);

// The curriculum a person trains by. not_found: the person, or nothing is published.
base::Result<std::string> curriculum_of(Store& store, const std::string& person_id);

// not_found: nothing is published.
base::Result<std::string> default_curriculum(Store& store);
// not_found: no published version of it.
base::Status set_default_curriculum(Store& store, const std::string& curriculum_id,
                                    const std::string& actor);

}  // namespace database
