// Everything an administrator sees of one person.
#pragma once

#include <nlohmann/json.hpp>

#include "app/server/site.h"
#include "database/people.h"
#include "database/store.h"

namespace app {

base::Result<nlohmann::json> person_detail_json(database::Store& store, Site& site,
                                                const database::Person& person);

}  // namespace app
