// One's own: settings and password.
#include <nlohmann/json.hpp>

#include "app/server/json_body.h"
#include "app/server/passwords.h"
#include "app/server/problem.h"
#include "app/server/routes/handlers.h"
#include "app/server/secrets.h"
#include "app/server/settings.h"
#include "app/server/sign_in_answer.h"
#include "app/server/site.h"
#include "database/settings.h"

namespace app {

using nlohmann::json;

base::Result<Response> get_settings(Call& call) {
  const auto stored = database::person_setting(call.store, call.me().person.id);
  if (!stored) return stored.error();
  if (!*stored) return json_response(default_settings());
  const json body = json::parse(**stored, nullptr, false);
  // what an older program stored may lack a field: the usual ones are better than none
  const auto settings = body.is_object() ? read_settings(body) : read_settings(json::object());
  return json_response(settings ? *settings : default_settings());
}

base::Result<Response> put_settings(Call& call) {
  const auto body = read_json_object(call.request);
  if (!body) return body.error();
  const auto settings = read_settings(*body);
  if (!settings) return settings.error();
  const auto saved =
      database::set_person_setting(call.store, call.me().person.id, settings->dump());
  if (!saved) return saved.error();
  return json_response(*settings);
}

base::Result<Response> post_password(Call& call) {
  const auto body = read_text_fields(call.request, {"old_password", "new_password"});
  if (!body) return body.error();
  const database::Person& person = call.me().person;
  const std::string old_password = (*body)["old_password"], fresh = (*body)["new_password"];
  Site& site = call.site;
  const double now = steady_seconds();
  const std::string key = token_hash(person.name);
  const double wait = site.names.wait(key, now);
  if (wait > 0.0) return too_often(wait);
  if (!verify_password(person.password_phc, old_password)) {
    site.names.failed(key, now);
    return base::Error{base::ErrorCode::invalid_input,
                       "The old password is wrong; ask your administrator for a link when you have "
                       "forgotten it."};
  }
  if (const auto good = check_new_password(fresh, person.name); !good) return good.error();
  const auto phc = hash_password(fresh);
  if (!phc) return phc.error();
  const auto changed =
      database::change_own_password(call.store, person.id, *phc, call.me().session_hash);
  if (!changed) return changed.error();
  site.names.succeeded(key);
  Response response;
  response.status = 204;
  return response;
}

}  // namespace app
