// The one-time link by which the first administrator of a site, or one who is locked out, sets a
// name and password. Whoever can start the program may make one; nobody else.
#pragma once

#include <string>

#include "database/store.h"
#include "sim/base/result.h"

namespace app {

// Makes a link's token, good once and for a day. The page is URL/setup?token=TOKEN.
base::Result<std::string> make_setup_token(database::Store& store);

// True while no administrator can sign in.
base::Result<bool> needs_setup(database::Store& store);

// Uses the token up: makes the named administrator, or gives an existing one this password and ends
// their sessions. Fails with denied (token), invalid_input (name, password) or conflict (the name
// is somebody's who is no administrator); then the token stays good.
base::Result<std::string> use_setup_link(database::Store& store, const std::string& token,
                                         const std::string& name, const std::string& password);

}  // namespace app
