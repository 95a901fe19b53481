// Brings the schema of an open database up to date. For database/*.cpp only.
#pragma once

#include "database/connection.h"

namespace database {

// Whether the file is ours, or empty and so to be made ours. Changes nothing. Fails with
// corrupt_data for the file of another program.
base::Status check_ownership(Store::Connection& connection);

// Runs the missing migrations in one transaction and gives the version reached. Fails with
// corrupt_data for a database written by a newer program.
base::Result<int> migrate(Store::Connection& connection);

}  // namespace database
