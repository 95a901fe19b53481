// One-time links by which a person sets the own password: the first one, or a new one when it was
// forgotten. Only a hash of the link's token is stored. A person has at most one link that works:
// making a link ends the ones before, and so do using it, withdrawing it, a password of one's own
// choice and being disabled.
#pragma once

#include <optional>
#include <string>

#include "database/people.h"
#include "database/store.h"

namespace database {

// How the link is made: a secret known to its reader alone.
struct InvitationLink {
  std::string token_hash;
  std::string expires_utc;
};

struct OpenInvitation {
  Person person;
  std::string expires_utc;
};

// conflict for people who cannot sign in whatever their password: disabled, simulated, published.
base::Status add_invitation(Store& store, const std::string& person_id, const InvitationLink& link,
                            const std::string& actor);
// A new person and the link in one step.
base::Result<Person> invite_person(Store& store, const NewPerson& person,
                                   const InvitationLink& link, const std::string& actor);
// Whose link it is. denied when it is unknown, used, withdrawn or too old, or its person disabled.
base::Result<OpenInvitation> open_invitation(Store& store, const std::string& token_hash);
// Uses the link: sets the password, ends the person's sessions. Once; else denied as above.
base::Result<Person> accept_invitation(Store& store, const std::string& token_hash,
                                       const std::string& phc);
// Until when the person's link works; none when there is none.
base::Result<std::optional<std::string>> invitation_expires(Store& store,
                                                            const std::string& person_id);

}  // namespace database
