// The web server: the browser application, its JSON interface and the live channel, on one port.
//
//   io threads (2)      sockets: HTTP and WebSocket, never a database, never a hash
//   quick lane (2)      handlers; each thread has its own connection to the database
//   slow lane (2)       Argon2id, meshes, starting a trial: so that they never delay a page
//   live trials         a thread each (app/session/live_trial.h) and one that carries its frames
//
// Listens on the loopback address unless TLS is on or a proxy in front of it is declared.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "curricula/catalogue.h"
#include "database/people.h"
#include "sim/base/result.h"

namespace app {

// Shown on the sign-in page of the demo, and only there.
struct DemoAccount {
  std::string name, password;
  database::Role role = database::Role::trainee;
};

struct ServerOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8080;       // 0: any free one, see Server::port()
  std::string database_url;        // sqlite:PATH
  std::filesystem::path web_root;  // the built browser application
  std::string version = "0.1.0";
  bool demo = false;
  std::vector<DemoAccount> demo_accounts;
  std::filesystem::path tls_certificate;  // PEM chain; TLS is on when this and the key are given
  std::filesystem::path tls_key;          // PEM
  bool behind_proxy = false;              // TLS ends at a proxy that sets X-Forwarded-For

  int max_connections = 512;
  int max_live_trials = 8;
  double session_idle_s = 8.0 * 3600.0;
  double session_absolute_s = 24.0 * 3600.0;
  double request_timeout_s = 30.0;
  double abandon_live_after_s = 600.0;      // a live trial nobody steers is aborted and filed
  double abandon_practice_after_s = 300.0;  // practice that stands still ends
  double requests_per_second = 100.0;       // per client, with bursts of ten seconds' worth
  bool build_scenes_ahead = true;           // vessels of the exercises, at start, in the background

  bool tls() const { return !tls_certificate.empty() || !tls_key.empty(); }
};

class Server {
 public:
  // `library`: the catalogue of anatomies and instruments that the exercises name.
  Server(ServerOptions options, curricula::Library library);
  ~Server();  // stops

  // Opens the database, closes what a killed server left running, listens. Fails with
  // invalid_input (an address that needs TLS, a certificate that cannot be read) or unavailable
  // (port taken, database).
  base::Status start();
  // Aborts and files the live trials, closes every connection, joins every thread.
  void stop();

  std::uint16_t port() const;
  std::string url() const;  // http://127.0.0.1:8080

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace app
