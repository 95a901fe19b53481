// Serving until told to stop: what `serve` and `demo` share.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/cli/command.h"
#include "app/server/server.h"

namespace app::cli {

// Starts the server, prints where it is ready, calls `greet` with its address, and returns when
// SIGINT or SIGTERM arrives, with everything filed. `greet` prints how to sign in, or with --json
// only returns it: it is printed with the address in one document. Returns the exit code.
int serve_until_stopped(ServerOptions options, curricula::Library library, Output& output,
                        const std::function<nlohmann::ordered_json(const std::string& url)>& greet);

// The options every server takes.
void add_server_options(CLI::App& command, ServerOptions& options, std::string& folder,
                        std::string& web_root);

// Held while a server uses a site's folder, so that a second one cannot mistake the first one's
// running trials for the leavings of a crash.
class FolderLock {
 public:
  // Fails with conflict when another server holds it.
  static base::Result<std::unique_ptr<FolderLock>> take(const std::string& folder);
  ~FolderLock();

 private:
  explicit FolderLock(int file) : file_(file) {}
  int file_;
};

// The folder is made when absent. Fails with unavailable when it cannot be.
base::Result<std::string> database_in(const std::string& folder);

}  // namespace app::cli
