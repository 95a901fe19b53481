// A copy of the whole store in one file, taken while others write.
#pragma once

#include <string>

#include "database/store.h"

namespace database {

// Copies one moment of the store to `path`, checks the copy, and only then gives it its name.
// Restoring is putting the file in place of the database while no program uses it. Fails with
// conflict when the file exists, unavailable when it cannot be written.
base::Status backup(Store& store, const std::string& path);

}  // namespace database
