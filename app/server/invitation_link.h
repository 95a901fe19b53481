// A fresh one-time link: the token is shown once, and only its hash is stored.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "database/invitations.h"

namespace app {

struct NewInvitation {
  std::string token;
  database::InvitationLink link;  // good for seven days
};

NewInvitation new_invitation();

// The wire's Invitation. The link is a path on this site.
nlohmann::json invitation_json(const database::Person& person, const NewInvitation& invitation);
// "/join?token=TOKEN"
std::string join_path(const std::string& token);

}  // namespace app
