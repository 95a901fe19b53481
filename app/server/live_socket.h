// One browser at a live trial, over WebSocket: frames out, commands in. For http_server.cpp only.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>  // Boost 1.74 under C++20 needs it first

#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/ssl/ssl_stream.hpp>

#include "app/server/live_trials.h"

namespace app {

// What the gate decided, and what the socket may use.
struct LiveDoor {
  LiveTrials* trials = nullptr;  // outlives every socket
  std::string trial_id;
  bool may_steer = false;
  // Asks the gate again, now and then: people sign out and are disabled. Calls back from another
  // thread with false when they may not stay.
  std::function<void(std::function<void(bool)>)> recheck;
  std::shared_ptr<void> connection;  // shared: counts as a connection as long as it lives
};

using UpgradeRequest = boost::beast::http::request<boost::beast::http::string_body>;

// Takes the connection over.
void open_live_socket(boost::beast::tcp_stream stream, UpgradeRequest upgrade, LiveDoor door);
void open_live_socket(boost::beast::ssl_stream<boost::beast::tcp_stream> stream,
                      UpgradeRequest upgrade, LiveDoor door);

}  // namespace app
