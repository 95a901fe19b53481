// Serving until told to stop: what `serve` and `demo` share.
#pragma once

#include <functional>
#include <string>

#include "app/cli/command.h"
#include "app/server/server.h"

namespace app::cli {

// Starts the server, prints where it is ready, calls `greet` with its address, and returns when
// SIGINT or SIGTERM arrives, with everything filed. Returns the exit code.
int serve_until_stopped(ServerOptions options, curricula::Library library, Output& output,
                        const std::function<void(const std::string& url)>& greet);

// The options every server takes.
void add_server_options(CLI::App& command, ServerOptions& options, std::string& folder,
                        std::string& web_root);

// The folder is made when absent. Fails with unavailable when it cannot be.
base::Result<std::string> database_in(const std::string& folder);

}  // namespace app::cli
