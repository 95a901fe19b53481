// What every answer tells the browser not to do.
#pragma once

#include <string>

#include "app/server/message.h"

namespace app {

// Scripts and connections of our own only; styles of our own or with the nonce; no frames.
std::string content_security_policy(const std::string& style_nonce);

// Adds what is missing. `secure`: the browser speaks HTTPS with us.
void add_security_headers(Response& response, bool secure);

}  // namespace app
