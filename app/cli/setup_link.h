// The one-time link by which a site gets its first administrator.
#pragma once

#include <string>

#include "database/store.h"

namespace app::cli {

// Good for 24 hours and one use. Only a hash of its token is stored.
base::Result<std::string> new_setup_link(database::Store& store, const std::string& site_url);

// Nobody can administer this site yet.
base::Result<bool> needs_administrator(database::Store& store);

}  // namespace app::cli
