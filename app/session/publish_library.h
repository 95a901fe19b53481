// Files the built-in curricula in the database, so that trials can point at their versions.
#pragma once

#include "curricula/catalogue.h"
#include "database/store.h"

namespace app {

// Publishes every curriculum of the library whose status is published and that is not there yet.
base::Status publish_library(database::Store& store, const curricula::Library& library);

// The row of one curriculum, as the database wants it.
base::Status publish(database::Store& store, const curricula::Curriculum& curriculum,
                     const std::string& actor);

}  // namespace app
