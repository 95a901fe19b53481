// The sockets: reads requests, hands them to the lanes, writes the answers; opens the live channel.
// Beast is behind this header and stays there.
#pragma once

#include <cstdint>
#include <memory>

#include "app/server/lane.h"
#include "app/server/router.h"
#include "app/server/site.h"
#include "sim/base/result.h"

namespace app {

class HttpServer {
 public:
  HttpServer(Site& site, const Router& router, Lane& quick, Lane& slow);
  ~HttpServer();  // stops

  // Fails with invalid_input (address, certificate) or unavailable (port taken).
  base::Status listen();
  void stop_accepting();
  // Closes every connection. The lanes must have stopped: their jobs answer to connections.
  void stop();
  std::uint16_t port() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace app
