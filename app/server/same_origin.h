// Does a request come from a page of this server? Browsers say where a page came from (Origin,
// Sec-Fetch-Site) and cannot be made to lie about it.
#pragma once

#include "app/server/message.h"
#include "app/server/server.h"

namespace app {

// `origin_needed`: also refuse a client that does not say, for the live channel, which browsers
// open across origins without asking.
bool is_same_origin(const Request& request, const ServerOptions& options, bool origin_needed);

// Is the server meant by this name? A server on the loopback address answers only to the names of
// the machine itself, or a hostile page could point its own name here.
bool is_own_host(const std::string& host, const ServerOptions& options);

bool is_loopback(const std::string& address);

}  // namespace app
