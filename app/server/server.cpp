#include "app/server/server.h"

#include <atomic>
#include <thread>
#include <utility>

#include <spdlog/spdlog.h>

#include "app/server/http_server.h"
#include "app/server/lane.h"
#include "app/server/router.h"
#include "app/server/same_origin.h"
#include "app/server/site.h"
#include "app/session/build_info.h"
#include "database/trials.h"

namespace app {
namespace {

constexpr int kQuickThreads = 2, kSlowThreads = 2;
constexpr std::size_t kQuickQueue = 256, kSlowQueue = 64;  // jobs that may wait

base::Status check_address(const ServerOptions& options) {
  if (is_loopback(options.address) || options.tls() || options.behind_proxy) return base::Done{};
  return base::Error{
      base::ErrorCode::invalid_input,
      "Listening on " + options.address +
          " would send passwords in the clear; give --tls-cert and --tls-key, or --behind-proxy "
          "when a proxy does TLS."};
}

}  // namespace

struct Server::Parts {
  Parts(ServerOptions options, curricula::Library library)
      : site(std::move(options), std::move(library)),
        router(site),
        http(site, router, quick, slow) {}

  // Closes what a killed server left open.
  base::Status tidy_up() {
    auto store = database::Store::open(site.options.database_url);
    if (!store) return store.error();
    const auto aborted = database::abort_unfinished_trials(**store);
    if (!aborted) return aborted.error();
    if (*aborted > 0) spdlog::warn("{} trials were cut off and are filed as aborted", *aborted);
    return base::Done{};
  }

  // So that the first "Start" waits neither for its vessel nor for the program's own hash.
  void build_scenes() {
    [[maybe_unused]] const std::string& build = build_id();
    auto store = database::Store::open(site.options.database_url);
    if (!store) return;
    const auto curriculum = site.curricula.standard(**store, site.scenes.library().catalogue());
    if (!curriculum) return;
    for (const curricula::Exercise& exercise : (*curriculum)->exercises) {
      if (stopping) return;
      [[maybe_unused]] const auto mesh = site.meshes.mesh(exercise.scene.anatomy);
    }
  }

  Site site;
  Router router;
  Lane quick, slow;
  HttpServer http;
  std::thread builder;
  std::atomic<bool> stopping{false};
};

Server::Server(ServerOptions options, curricula::Library library)
    : parts_(std::make_unique<Parts>(std::move(options), std::move(library))) {}

Server::~Server() { stop(); }

base::Status Server::start() {
  const ServerOptions& options = parts_->site.options;
  if (const auto allowed = check_address(options); !allowed) return allowed.error();
  if (const auto tidy = parts_->tidy_up(); !tidy) return tidy.error();
  const auto quick = parts_->quick.start(options.database_url, kQuickThreads, kQuickQueue);
  if (!quick) return quick.error();
  const auto slow = parts_->slow.start(options.database_url, kSlowThreads, kSlowQueue);
  if (!slow) return slow.error();
  if (const auto listening = parts_->http.listen(); !listening) return listening.error();
  if (options.build_scenes_ahead) {
    parts_->builder = std::thread([parts = parts_.get()] { parts->build_scenes(); });
  }
  return base::Done{};
}

void Server::stop() {
  parts_->stopping = true;
  parts_->http.stop_accepting();
  parts_->site.live.stop();
  parts_->quick.stop();
  parts_->slow.stop();
  parts_->http.stop();
  if (parts_->builder.joinable()) parts_->builder.join();
}

std::uint16_t Server::port() const { return parts_->http.port(); }

std::string Server::url() const {
  const ServerOptions& options = parts_->site.options;
  const bool ipv6 = options.address.find(':') != std::string::npos;
  const std::string host = ipv6 ? "[" + options.address + "]" : options.address;
  return (options.tls() ? "https://" : "http://") + host + ":" + std::to_string(port());
}

}  // namespace app
