// Passwords: what is accepted, and how they are stored (Argon2id, PHC text).
//
// Hashing takes about 20 MiB and tens of milliseconds. Do it where only few run at a time.
#pragma once

#include <string>

#include "sim/base/result.h"

namespace app {

// 8 to 128 characters, not a common one, not the name. No rules on composition. The error says
// what to do.
base::Status check_new_password(const std::string& password, const std::string& name);

// unavailable when there is not enough memory.
base::Result<std::string> hash_password(const std::string& password);
// False for an empty or unreadable PHC text.
bool verify_password(const std::string& phc, const std::string& password);
// Takes as long as verify_password and knows no password: for names that do not exist.
void spend_password_time(const std::string& password);
// Made with weaker parameters than today's.
bool needs_rehash(const std::string& phc);

}  // namespace app
