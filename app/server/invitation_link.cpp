#include "app/server/invitation_link.h"

#include "app/server/expiry.h"
#include "app/server/secrets.h"

namespace app {
namespace {

constexpr std::time_t kGoodFor = 7 * 24 * 3600;  // s

}  // namespace

NewInvitation new_invitation() {
  NewInvitation invitation;
  invitation.token = new_token();
  invitation.link = {token_hash(invitation.token), utc_in(kGoodFor)};
  return invitation;
}

std::string join_path(const std::string& token) { return "/join?token=" + token; }

nlohmann::json invitation_json(const database::Person& person, const NewInvitation& invitation) {
  return {{"person_id", person.id},
          {"name", person.name},
          {"display_name", person.display_name},
          {"link", join_path(invitation.token)},
          {"expires_utc", invitation.link.expires_utc}};
}

}  // namespace app
