// Signing in and out, and what is known before: the site and its set-up.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/server/json_body.h"
#include "app/server/passwords.h"
#include "app/server/problem.h"
#include "app/server/routes/handlers.h"
#include "app/server/secrets.h"
#include "app/server/setup_link.h"
#include "app/server/sign_in_answer.h"
#include "app/server/site.h"

namespace app {
namespace {

using nlohmann::json;

// The same for a wrong name and a wrong password, so that nobody learns which names exist.
Response wrong_credentials() {
  return problem(401, "wrong_credentials", "The name or the password is wrong.");
}

// The person, if name and password belong together. Takes the same time either way.
base::Result<std::optional<database::Person>> check_credentials(database::Store& store,
                                                                const std::string& name,
                                                                const std::string& password) {
  const std::optional<database::Person> nobody;
  auto person = database::person_by_name(store, name);
  if (!person && person.error().code != base::ErrorCode::not_found) return person.error();
  if (!person || person->password_phc.empty()) {
    spend_password_time(password);
    return nobody;
  }
  if (!verify_password(person->password_phc, password)) return nobody;
  if (person->disabled || person->kind != database::PersonKind::live) return nobody;
  return std::optional<database::Person>(*std::move(person));
}

base::Status rehash_if_needed(database::Store& store, const database::Person& person,
                              const std::string& password) {
  if (!needs_rehash(person.password_phc)) return base::Done{};
  const auto phc = hash_password(password);
  if (!phc) return phc.error();
  return database::set_password(store, person.id, *phc, "system");
}

}  // namespace

base::Result<Response> get_health(Call& call) {
  return json_response({{"status", "ok"}, {"schema_version", call.store.schema_version()}});
}

base::Result<Response> get_site(Call& call) {
  const auto needed = needs_setup(call.store);
  if (!needed) return needed.error();
  json accounts = json::array();
  if (call.site.options.demo) {
    for (const DemoAccount& account : call.site.options.demo_accounts) {
      accounts.push_back({{"name", account.name},
                          {"password", account.password},
                          {"role", database::word(account.role)}});
    }
  }
  return json_response({{"demo", call.site.options.demo},
                        {"version", call.site.options.version},
                        {"needs_setup", *needed},
                        {"demo_accounts", accounts}});
}

base::Result<Response> get_session(Call& call) {
  return session_response(call.me().person, call.me().csrf_token, call.site);
}

base::Result<Response> post_session(Call& call) {
  const auto body = read_text_fields(call.request, {"name", "password"});
  if (!body) return body.error();
  const std::string name = (*body)["name"], password = (*body)["password"];
  Site& site = call.site;
  const double now = steady_seconds();
  const std::string key = token_hash(name);  // of one length, however long the name
  const double wait =
      std::max(site.names.wait(key, now), site.clients.wait(call.request.client, now));
  if (wait > 0.0) return too_often(wait);

  const auto person = check_credentials(call.store, name, password);
  if (!person) return person.error();
  if (!*person) {
    site.names.failed(key, now);
    site.clients.failed(call.request.client, now);
    return wrong_credentials();
  }
  site.names.succeeded(key);
  const auto rehashed = rehash_if_needed(call.store, **person, password);
  if (!rehashed) return rehashed.error();
  return sign_in(call, **person);
}

base::Result<Response> delete_session(Call& call) {
  const auto ended = database::end_web_session(call.store, call.me().session_hash);
  if (!ended) return ended.error();
  Response response;
  response.status = 204;
  response.headers.emplace_back("Set-Cookie", ended_session_cookie(call.site.session_rules()));
  return response;
}

base::Result<Response> post_setup(Call& call) {
  const auto body = read_text_fields(call.request, {"token", "name", "password"});
  if (!body) return body.error();
  const double now = steady_seconds();
  const double wait = call.site.clients.wait(call.request.client, now);
  if (wait > 0.0) return too_often(wait);

  const auto person_id =
      use_setup_link(call.store, (*body)["token"], (*body)["name"], (*body)["password"]);
  if (!person_id) {
    if (person_id.error().code == base::ErrorCode::denied) {
      call.site.clients.failed(call.request.client, now);
    }
    return person_id.error();
  }
  const auto person = database::person_by_id(call.store, *person_id);
  if (!person) return person.error();
  return sign_in(call, *person);
}

}  // namespace app
