// A whole server on a free port with people, a curriculum and a small web folder, and a plain
// client to talk to it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/server/server.h"
#include "database/people.h"
#include "database/store.h"

namespace app::test {

inline constexpr const char* kPassword = "a fine long phrase";

struct Answer {
  int status = 0;
  std::string body;
  std::multimap<std::string, std::string> headers;  // lower-case names

  std::string header(const std::string& name) const;  // the first, or empty
  nlohmann::json json() const;                        // discarded when it is none
};

using Headers = std::map<std::string, std::string>;

// A browser of sorts: keeps its cookie and its CSRF token, opens a connection per request.
class Client {
 public:
  explicit Client(std::uint16_t port) : port_(port) {}

  Answer send(const std::string& method, const std::string& target, const std::string& body = "",
              const Headers& more = {});
  Answer get(const std::string& target) { return send("GET", target); }
  Answer post(const std::string& target, const nlohmann::json& body);
  // Signs in with kPassword, remembering the cookie; expects success.
  void sign_in(const std::string& name);

  std::string cookie;  // "cathedra=..."
  std::string csrf;

 private:
  std::uint16_t port_;
};

// Sends bytes as they are and returns all that comes back until the server closes.
std::string send_raw(std::uint16_t port, const std::string& bytes);

// In a fresh folder: people ann (trainee, group A), ben (trainee, B), ina (instructor, A), ada
// (administrator), rex (researcher), and no.1 (published).
class Workplace {
 public:
  Workplace();
  ~Workplace();

  ServerOptions options() const;  // port 0
  curricula::Library library() const;
  database::Store& store() { return *store_; }
  std::string id_of(const std::string& name);
  // A finished trial of the exercise "linear".
  std::string add_trial(const std::string& name);

  const std::filesystem::path folder;

 private:
  std::unique_ptr<database::Store> store_;
};

// A started server in a workplace of its own.
class RunningServer {
 public:
  explicit RunningServer(void (*change)(ServerOptions&) = nullptr);
  Client client() const { return Client(server.port()); }
  Client client_of(const std::string& name) const;

  Workplace workplace;
  Server server;
};

}  // namespace app::test
