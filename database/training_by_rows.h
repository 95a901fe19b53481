// Who trains by what, inside a transaction. For database/*.cpp only.
#pragma once

#include <optional>
#include <string>

#include <soci/soci.h>

#include "sim/base/result.h"

namespace database {

// As assign_curriculum(); the caller has checked the actor and that the person exists.
base::Status change_assignment(soci::session& sql, const std::string& person_id,
                               const std::optional<std::string>& curriculum_id,
                               const std::string& actor);

// The default of the site; null when nothing is published.
std::optional<std::string> load_default_curriculum(soci::session& sql);
// Writes it down; the caller has checked that the curriculum is published.
void store_default_curriculum(soci::session& sql, const std::string& curriculum_id,
                              const std::string& actor);
// Makes the default that follows from a rule one that is written down.
void fix_default_curriculum(soci::session& sql, const std::string& actor);

// How many people are assigned the curriculum.
int assigned_to(soci::session& sql, const std::string& curriculum_id);

}  // namespace database
