// Who is signed in: server-side sessions under a random cookie. The database holds only the hash
// of the cookie's value, so that a copy of it opens no session.
#pragma once

#include <optional>
#include <string>

#include "app/server/message.h"
#include "database/people.h"
#include "database/store.h"
#include "sim/base/result.h"

namespace app {

struct SessionRules {
  double idle_s = 8.0 * 3600.0;       // since the last request
  double absolute_s = 24.0 * 3600.0;  // since signing in
  bool secure = false;                // HTTPS: the cookie never travels in the clear
};

// The person behind a request.
struct Viewer {
  database::Person person;
  std::string csrf_token;
  std::string session_hash;
};

struct BegunSession {
  std::string token;  // for the cookie, and nowhere else
  std::string csrf_token;
};

base::Result<BegunSession> begin_session(database::Store& store, const std::string& person_id);

// Nobody when there is no cookie, or its session has ended, run out, or belongs to somebody
// disabled. Fails only when the database does.
base::Result<std::optional<Viewer>> viewer_of(database::Store& store, const Request& request,
                                              const SessionRules& rules);

// Values of Set-Cookie.
std::string session_cookie(const std::string& token, const SessionRules& rules);
std::string ended_session_cookie(const SessionRules& rules);

}  // namespace app
