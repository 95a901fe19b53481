#include "app/server/sign_in_answer.h"

#include <cmath>

#include "app/server/json_body.h"
#include "app/server/problem.h"
#include "app/server/site.h"

namespace app {

Response session_response(const database::Person& person, const std::string& csrf_token,
                          const Site& site) {
  return json_response({{"person_id", person.id},
                        {"name", person.name},
                        {"display_name", person.display_name},
                        {"role", database::word(person.role)},
                        {"csrf", csrf_token},
                        {"demo", site.options.demo}});
}

Response too_often(double wait_s) {
  const int seconds = static_cast<int>(std::ceil(wait_s));
  Response response = problem(
      429, "too_many", "Too many attempts; try again in " + std::to_string(seconds) + " seconds.");
  response.headers.emplace_back("Retry-After", std::to_string(seconds));
  return response;
}

base::Result<Response> sign_in(Call& call, const database::Person& person) {
  if (call.viewer) {
    const auto ended = database::end_web_session(call.store, call.viewer->session_hash);
    if (!ended) return ended.error();
  }
  if (const auto noted = database::note_sign_in(call.store, person.id); !noted) {
    return noted.error();
  }
  const auto begun = begin_session(call.store, person.id);
  if (!begun) return begun.error();
  Response response = session_response(person, begun->csrf_token, call.site);
  response.headers.emplace_back("Set-Cookie",
                                session_cookie(begun->token, call.site.session_rules()));
  return response;
}

}  // namespace app
