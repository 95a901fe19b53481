// What several ways of signing in share: by password, by the set-up link, by an invitation.
#pragma once

#include "app/server/router.h"
#include "database/people.h"
#include "sim/base/result.h"

namespace app {

// The wire's Session.
Response session_response(const database::Person& person, const std::string& csrf_token,
                          const Site& site);
// A new session, and the cookie that opens it. The one before ends.
base::Result<Response> sign_in(Call& call, const database::Person& person);
// Refuses who has tried too often.
Response too_often(double wait_s);

}  // namespace app
