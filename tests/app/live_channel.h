// A browser's end of the live channel.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <utility>  // Boost 1.74 under C++20 needs it first

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>
#include <sys/socket.h>

namespace app::test {

namespace beast = boost::beast;
namespace net = boost::asio;
namespace websocket = beast::websocket;
using tcp = net::ip::tcp;

// Positions in a frame, from x-frame in app/wire/wire.schema.yaml.
inline constexpr std::size_t kFlagsAt = 6, kStepAt = 12, kAxialAt = 44;
inline constexpr std::uint32_t kMagic = 0x46544143;
inline constexpr unsigned kPaused = 1, kFiled = 4;

template <class T>
T read_at(const std::string& bytes, std::size_t at) {
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

// A browser's end of the channel.
class Channel {
 public:
  // 101 when it is open; anything else when it was refused.
  int open(std::uint16_t port, const std::string& trial, const std::string& cookie) {
    socket_.next_layer().connect({net::ip::address_v4::loopback(), port});
    const timeval limit{20, 0};
    setsockopt(socket_.next_layer().native_handle(), SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
    const std::string host = "127.0.0.1:" + std::to_string(port);
    socket_.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
      request.set(beast::http::field::origin, "http://" + host);
      request.set(beast::http::field::cookie, cookie);
    }));
    websocket::response_type answer;
    beast::error_code failed;
    socket_.handshake(answer, host, "/api/live/" + trial, failed);
    return answer.result_int();
  }

  void send(const std::string& text) {
    socket_.text(true);
    beast::error_code ignored;  // a closed channel shows when reading
    socket_.write(net::buffer(text), ignored);
  }
  void send(const nlohmann::json& message) { send(message.dump()); }

  // The next message, frame or notice; nothing when the channel is closed.
  std::optional<std::string> next() {
    beast::flat_buffer buffer;
    beast::error_code failed;
    socket_.read(buffer, failed);
    if (failed) return std::nullopt;
    return beast::buffers_to_string(buffer.data());
  }
  bool got_frame() const { return socket_.got_binary(); }

  std::string frame() {
    for (auto message = next(); message; message = next()) {
      if (got_frame()) return *message;
    }
    return {};
  }
  // The first frame that fulfils the condition; empty when the channel closes before or it takes
  // more than ten seconds.
  std::string frame_where(const std::function<bool(const std::string&)>& wanted) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (std::chrono::steady_clock::now() < until) {
      std::string frame = this->frame();
      if (frame.empty() || wanted(frame)) return frame;
    }
    return {};
  }
  nlohmann::json notice() {
    for (auto message = next(); message; message = next()) {
      if (!got_frame()) return nlohmann::json::parse(*message);
    }
    return nullptr;
  }
  bool closes() {
    while (next()) {
    }
    return true;
  }

  void close() {
    beast::error_code ignored;
    socket_.close(websocket::close_code::normal, ignored);
  }
  // As when the cable is pulled, but told by the operating system.
  void drop() { socket_.next_layer().close(); }

 private:
  net::io_context io_;
  websocket::stream<tcp::socket> socket_{io_};
};

inline bool is_paused(const std::string& frame) {
  return (read_at<std::uint16_t>(frame, kFlagsAt) & kPaused) != 0;
}

}  // namespace app::test
