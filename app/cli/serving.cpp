#include "app/cli/serving.h"

#include <csignal>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "app/session/build_info.h"

namespace app::cli {

int serve_until_stopped(
    ServerOptions options, curricula::Library library, Output& output,
    const std::function<nlohmann::ordered_json(const std::string& url)>& greet) {
  // every thread inherits the mask, so that only sigwait below sees these signals
  sigset_t stop_signals;
  sigemptyset(&stop_signals);
  sigaddset(&stop_signals, SIGINT);
  sigaddset(&stop_signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &stop_signals, nullptr);

  options.version = kVersion;
  if (!std::filesystem::exists(options.web_root / "index.html")) {
    output.fail("the browser application is not built at " + options.web_root.string() +
                "; run ./run build");
    return output.exit_code;
  }
  Server server(std::move(options), std::move(library));
  const base::Status started = server.start();
  if (!started) {
    output.fail(started.error());
    return output.exit_code;
  }
  if (!output.json) std::cout << "Cathedra is ready at " << server.url() << std::endl;
  nlohmann::ordered_json ready = {{"url", server.url()}};
  ready.update(greet(server.url()));
  if (output.json) {
    output.print(ready);
    std::cout << std::flush;
  } else {
    std::cout << "Stop with Ctrl-C." << std::endl;
  }

  int signal = 0;
  sigwait(&stop_signals, &signal);
  if (!output.json) std::cout << "\nStopping: running trials are filed." << std::endl;
  server.stop();
  return kWorked;
}

void add_server_options(CLI::App& command, ServerOptions& options, std::string& folder,
                        std::string& web_root) {
  command.add_option("--data", folder, "Folder of this site's database, made when absent")
      ->capture_default_str();
  command.add_option("--port", options.port, "TCP port; 0 takes a free one")->capture_default_str();
  command
      .add_option("--address", options.address,
                  "Address to listen on; other than loopback it needs TLS or --behind-proxy")
      ->capture_default_str();
  command.add_option("--tls-cert", options.tls_certificate, "Certificate chain, PEM");
  command.add_option("--tls-key", options.tls_key, "Private key, PEM");
  command.add_flag("--behind-proxy", options.behind_proxy,
                   "TLS ends at a proxy in front of this server");
  command.add_option("--web-root", web_root, "The built browser application");
}

base::Result<std::unique_ptr<FolderLock>> FolderLock::take(const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / "cathedra.lock").string();
  const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0) {
    return base::Error{base::ErrorCode::unavailable,
                       "cannot write in the folder " + folder + "; choose another with --data"};
  }
  if (flock(file, LOCK_EX | LOCK_NB) != 0) {
    close(file);
    return base::Error{base::ErrorCode::conflict,
                       "another Cathedra serves the folder " + folder +
                           " already; stop it first, or choose another with --data"};
  }
  return std::unique_ptr<FolderLock>(new FolderLock(file));
}

FolderLock::~FolderLock() { close(file_); }

base::Result<std::string> database_in(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return base::Error{base::ErrorCode::unavailable, "cannot make the folder " + folder + " (" +
                                                         error.message() +
                                                         "); choose another with --data"};
  }
  return "sqlite:" + (std::filesystem::path(folder) / "cathedra.db").string();
}

}  // namespace app::cli
