// The way in by an invitation: who it is for, and setting the password. For people who are not
// signed in; guessing is slowed down as at signing in.
#include <nlohmann/json.hpp>

#include "app/server/json_body.h"
#include "app/server/passwords.h"
#include "app/server/routes/handlers.h"
#include "app/server/secrets.h"
#include "app/server/sign_in_answer.h"
#include "app/server/site.h"
#include "database/invitations.h"

namespace app {
namespace {

base::Result<database::OpenInvitation> find_invitation(Call& call, const std::string& token) {
  auto open = database::open_invitation(call.store, token_hash(token));
  if (!open && open.error().code == base::ErrorCode::denied) {
    call.site.clients.failed(call.request.client, steady_seconds());
  }
  return open;
}

}  // namespace

base::Result<Response> post_look_at_invitation(Call& call) {
  const auto body = read_text_fields(call.request, {"token"});
  if (!body) return body.error();
  const double wait = call.site.clients.wait(call.request.client, steady_seconds());
  if (wait > 0.0) return too_often(wait);
  const auto open = find_invitation(call, (*body)["token"]);
  if (!open) return open.error();
  return json_response({{"name", open->person.name},
                        {"display_name", open->person.display_name},
                        {"expires_utc", open->expires_utc}});
}

base::Result<Response> post_invitation(Call& call) {
  const auto body = read_text_fields(call.request, {"token", "password"});
  if (!body) return body.error();
  const std::string token = (*body)["token"], password = (*body)["password"];
  const double wait = call.site.clients.wait(call.request.client, steady_seconds());
  if (wait > 0.0) return too_often(wait);
  const auto open = find_invitation(call, token);
  if (!open) return open.error();
  if (const auto good = check_new_password(password, open->person.name); !good) {
    return good.error();
  }
  const auto phc = hash_password(password);
  if (!phc) return phc.error();
  const auto person = database::accept_invitation(call.store, token_hash(token), *phc);
  if (!person) return person.error();
  call.site.names.succeeded(token_hash(person->name));  // the failures with the forgotten password
  return sign_in(call, *person);
}

}  // namespace app
