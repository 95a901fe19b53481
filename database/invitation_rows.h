// Adds invitations inside a transaction. For database/*.cpp only.
#pragma once

#include <string>

#include <soci/soci.h>

#include "database/invitations.h"

namespace database {

// Ends the person's links before and audits it; the caller has checked the actor.
base::Status insert_invitation(soci::session& sql, const Person& person, const InvitationLink& link,
                               const std::string& actor);

}  // namespace database
