#include "app/server/sessions.h"

#include <algorithm>
#include <ctime>
#include <limits>

#include "app/server/secrets.h"

namespace app {
namespace {

constexpr double kTouchEvery = 60.0;  // s; a write per request would be a write for nothing

// The prefix makes browsers refuse the cookie from another host or over plain HTTP.
std::string cookie_name(const SessionRules& rules) {
  return rules.secure ? "__Host-cathedra" : "cathedra";
}

std::string attributes(const SessionRules& rules) {
  return std::string("; Path=/; HttpOnly; SameSite=Strict") + (rules.secure ? "; Secure" : "");
}

// Seconds since a UTC instant "2026-03-31T10:20:30.400Z"; infinite when it cannot be read, so that
// an unreadable session has run out.
double seconds_since(const std::string& utc) {
  std::tm parts{};
  if (strptime(utc.c_str(), "%Y-%m-%dT%H:%M:%S", &parts) == nullptr) {
    return std::numeric_limits<double>::infinity();
  }
  return std::difftime(std::time(nullptr), timegm(&parts));
}

}  // namespace

base::Result<BegunSession> begin_session(database::Store& store, const std::string& person_id) {
  BegunSession begun{new_token(), new_token()};
  const std::string now = database::utc_now();
  const auto added = database::add_web_session(store, token_hash(begun.token),
                                               {person_id, begun.csrf_token, now, now});
  if (!added) return added.error();
  return begun;
}

base::Result<std::optional<Viewer>> viewer_of(database::Store& store, const Request& request,
                                              const SessionRules& rules) {
  const std::optional<Viewer> nobody;
  const std::string token = request.cookie(cookie_name(rules));
  if (token.empty()) return nobody;

  const std::string hash = token_hash(token);
  const auto session = database::web_session(store, hash);
  if (!session) {
    if (session.error().code == base::ErrorCode::not_found) return nobody;
    return session.error();
  }
  const double idle = seconds_since(session->last_seen_utc);
  if (idle > rules.idle_s || seconds_since(session->created_utc) > rules.absolute_s) {
    const auto ended = database::end_web_session(store, hash);
    if (!ended) return ended.error();
    return nobody;
  }
  auto person = database::person_by_id(store, session->person_id);
  if (!person) {
    if (person.error().code == base::ErrorCode::not_found) return nobody;
    return person.error();
  }
  if (person->disabled || person->kind != database::PersonKind::live) return nobody;

  if (idle > std::min(kTouchEvery, rules.idle_s / 4.0)) {
    const auto touched = database::touch_web_session(store, hash);
    if (!touched) return touched.error();
  }
  return std::optional<Viewer>(Viewer{*std::move(person), session->csrf_token, hash});
}

std::string session_cookie(const std::string& token, const SessionRules& rules) {
  return cookie_name(rules) + "=" + token + attributes(rules);
}

std::string ended_session_cookie(const SessionRules& rules) {
  return cookie_name(rules) + "=" + attributes(rules) + "; Max-Age=0";
}

}  // namespace app
