// What people set for themselves: one JSON text each, as their browser sends it. What it may hold
// is the server's business.
#pragma once

#include <optional>
#include <string>

#include "database/store.h"

namespace database {

base::Result<std::optional<std::string>> person_setting(Store& store, const std::string& person_id);
// The same again changes nothing and is not audited.
base::Status set_person_setting(Store& store, const std::string& person_id,
                                const std::string& json);

}  // namespace database
