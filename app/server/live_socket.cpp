#include "app/server/live_socket.h"

#include <chrono>
#include <deque>
#include <variant>

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/ssl.hpp>
#include <boost/beast/websocket.hpp>
#include <boost/beast/websocket/ssl.hpp>

#include "app/server/views/live_message.h"

namespace app {
namespace {

namespace beast = boost::beast;
namespace net = boost::asio;
namespace websocket = beast::websocket;

constexpr std::size_t kLongestMessage = 4096;        // bytes, from the browser
constexpr int kMistakesAllowed = 10;                 // malformed messages before the door closes
constexpr std::size_t kNoticesWaiting = 64;          // a browser that reads none is not there
constexpr auto kSilence = std::chrono::seconds(10);  // of the line, pings included
constexpr auto kRecheck = std::chrono::seconds(15);

// All its members are used on the connection's strand only.
template <class Stream>
class LiveSocket : public std::enable_shared_from_this<LiveSocket<Stream>> {
 public:
  LiveSocket(Stream stream, LiveDoor door)
      : socket_(std::move(stream)), timer_(socket_.get_executor()), door_(std::move(door)) {}

  void open(UpgradeRequest upgrade) {
    beast::get_lowest_layer(socket_).expires_never();  // the socket has timeouts of its own
    websocket::stream_base::timeout timeout{};
    timeout.handshake_timeout = kSilence;
    timeout.idle_timeout = kSilence;
    timeout.keep_alive_pings = true;
    socket_.set_option(timeout);
    socket_.read_message_max(kLongestMessage);
    auto request = std::make_shared<UpgradeRequest>(std::move(upgrade));  // shared: with the wait
    socket_.async_accept(*request, [self = this->shared_from_this(), request](auto failed) {
      if (!failed) self->take_seat();
    });
  }

 private:
  // Runs `what` on the strand, if the socket is still there.
  template <class What>
  auto on_strand(What what) {
    return [weak = this->weak_from_this(), executor = socket_.get_executor(), what](auto... value) {
      net::post(executor, [weak, what, value...] {
        if (const auto self = weak.lock()) what(*self, value...);
      });
    };
  }

  void take_seat() {
    LiveListener listener;
    listener.frame = on_strand([](LiveSocket& self, const Frame& frame) {
      self.frame_ = frame;  // an older one not yet sent is of no use any more
      self.write_next();
    });
    listener.finished = on_strand([](LiveSocket& self, bool practice) {
      self.say(finished_notice(self.door_.trial_id, practice));
    });
    listener.failed =
        on_strand([](LiveSocket& self, const std::string& why) { self.say(error_notice(why)); });
    auto seat = door_.trials->sit(door_.trial_id, door_.may_steer, std::move(listener));
    if (!seat) {
      say(error_notice(seat.error().message));
      close_after_writing_ = true;
      return write_next();
    }
    seat_ = *std::move(seat);
    if (door_.may_steer && !seat_->take_wheel()) say(second_tab_notice());
    read_next();
    recheck_later();
  }

  void read_next() {
    socket_.async_read(buffer_, [self = this->shared_from_this()](auto failed, std::size_t) {
      if (failed) return self->leave();
      self->receive();
      if (!self->close_after_writing_) self->read_next();
    });
  }

  void receive() {
    const std::string text = beast::buffers_to_string(buffer_.data());
    buffer_.consume(buffer_.size());
    const auto message = socket_.got_text()
                             ? read_client_message(text)
                             : base::Result<ClientMessage>(base::Error{
                                   base::ErrorCode::invalid_input, "Messages must be text."});
    if (!message) return note_mistake(message.error().message);
    if (const auto* command = std::get_if<LiveCommand>(&*message)) {
      seat_->command(*command);
    } else if (const auto* ping = std::get_if<LivePing>(&*message)) {
      say(pong_notice(ping->sent_ms));
    } else {
      control(std::get<LiveControl>(*message));
    }
  }

  void control(LiveControl control) {
    if (!door_.may_steer) return say(error_notice("Only the person whose trial it is steers it."));
    // whoever comes back after a lost connection takes the wheel again by going on
    if (!seat_->take_wheel()) return say(second_tab_notice());
    switch (control) {
      case LiveControl::pause:
        return seat_->pause();
      case LiveControl::resume:
        return seat_->resume();
      case LiveControl::end:
        return seat_->abort();
    }
  }

  void note_mistake(const std::string& sentence) {
    say(error_notice(sentence));
    if (++mistakes_ >= kMistakesAllowed) close_after_writing_ = true;
    write_next();
  }

  void say(std::string notice) {
    if (notices_.size() >= kNoticesWaiting) return leave();
    notices_.push_back(std::move(notice));
    write_next();
  }

  void write_next() {
    if (writing_ || left_) return;
    if (!notices_.empty()) {
      sending_text_ = std::move(notices_.front());
      notices_.pop_front();
      socket_.text(true);
      write(net::buffer(sending_text_));
    } else if (close_after_writing_) {
      close();
    } else if (frame_) {
      sending_frame_ = std::exchange(frame_, nullptr);
      socket_.binary(true);
      write(net::buffer(*sending_frame_));
    }
  }

  void write(net::const_buffer bytes) {
    writing_ = true;
    socket_.async_write(bytes, [self = this->shared_from_this()](auto failed, std::size_t) {
      self->writing_ = false;
      if (failed) return self->leave();
      self->write_next();
    });
  }

  void recheck_later() {
    timer_.expires_after(kRecheck);
    timer_.async_wait([self = this->shared_from_this()](auto failed) {
      if (failed || self->left_) return;
      self->door_.recheck(self->on_strand([](LiveSocket& socket, bool may_stay) {
        if (may_stay) return;
        socket.say(error_notice("You are signed out; sign in again to go on."));
        socket.close_after_writing_ = true;
        socket.write_next();
      }));
      self->recheck_later();
    });
  }

  // Says goodbye; giving up the seat pauses the trial.
  void close() {
    left_ = true;
    seat_.reset();
    timer_.cancel();
    socket_.async_close(websocket::close_code::policy_error,
                        [self = this->shared_from_this()](auto) {});
  }

  // The line is dead.
  void leave() {
    if (left_) return;
    left_ = true;
    seat_.reset();
    timer_.cancel();
    beast::get_lowest_layer(socket_).close();
  }

  websocket::stream<Stream> socket_;
  net::steady_timer timer_;
  LiveDoor door_;
  std::unique_ptr<LiveTrials::Seat> seat_;
  beast::flat_buffer buffer_{kLongestMessage};
  std::deque<std::string> notices_;
  std::string sending_text_;
  Frame frame_, sending_frame_;
  bool writing_ = false;
  bool close_after_writing_ = false;
  bool left_ = false;
  int mistakes_ = 0;
};

template <class Stream>
void open(Stream stream, UpgradeRequest upgrade, LiveDoor door) {
  // shared: with the operations under way on it
  std::make_shared<LiveSocket<Stream>>(std::move(stream), std::move(door))
      ->open(std::move(upgrade));
}

}  // namespace

void open_live_socket(beast::tcp_stream stream, UpgradeRequest upgrade, LiveDoor door) {
  open(std::move(stream), std::move(upgrade), std::move(door));
}

void open_live_socket(beast::ssl_stream<beast::tcp_stream> stream, UpgradeRequest upgrade,
                      LiveDoor door) {
  open(std::move(stream), std::move(upgrade), std::move(door));
}

}  // namespace app
