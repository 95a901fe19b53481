#include "app/server/http_server.h"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <utility>  // Boost 1.74 under C++20 needs it first
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/strand.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/ssl.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <spdlog/spdlog.h>

#include "app/server/live_socket.h"
#include "app/server/problem.h"
#include "app/server/same_origin.h"
#include "app/server/security_headers.h"

namespace app {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace net = boost::asio;
namespace ssl = net::ssl;
using tcp = net::ip::tcp;
using PlainStream = beast::tcp_stream;
using TlsStream = beast::ssl_stream<beast::tcp_stream>;

constexpr int kThreads = 2;
constexpr std::uint32_t kHeaderLimit = 16 * 1024;           // bytes
constexpr std::size_t kLargestBody = std::size_t{1} << 20;  // bytes, of any route
constexpr auto kLinger = std::chrono::seconds(2);           // for a refused client to read why

// What every connection uses; outlives them all.
struct Service {
  Site& site;
  const Router& router;
  Lane& quick;
  Lane& slow;
  std::atomic<int> connections{0};
};

// Counts one connection for as long as it lives.
std::shared_ptr<void> count_connection(Service& service) {
  ++service.connections;
  return {nullptr, [&service](void*) { --service.connections; }};
}

std::optional<Method> method_of(http::verb verb) {
  switch (verb) {
    case http::verb::get:
    case http::verb::head:
      return Method::get;
    case http::verb::post:
      return Method::post;
    case http::verb::put:
      return Method::put;
    case http::verb::delete_:
      return Method::remove;
    default:
      return std::nullopt;
  }
}

std::string lower(beast::string_view text) {
  std::string lowered(text);
  std::transform(lowered.begin(), lowered.end(), lowered.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lowered;
}

// The browser's address: the peer, or the one the declared proxy saw.
std::string client_of(const Request& request, const std::string& peer,
                      const ServerOptions& options) {
  const std::string& forwarded = request.header("x-forwarded-for");
  if (!options.behind_proxy || forwarded.empty()) return peer;
  const std::size_t comma = forwarded.rfind(',');
  std::string last = comma == std::string::npos ? forwarded : forwarded.substr(comma + 1);
  last.erase(std::remove(last.begin(), last.end(), ' '), last.end());
  return last.substr(0, 64);
}

// What the parser's failure is in words; nothing when the client merely went away.
std::optional<Response> parse_problem(beast::error_code failed) {
  if (failed == http::error::end_of_stream || failed == http::error::partial_message) {
    return std::nullopt;
  }
  if (failed == http::error::body_limit) {
    return problem(413, "too_large", "The request is too large.");
  }
  if (failed == http::error::header_limit) {
    return problem(431, "too_large", "The headers of the request are too large.");
  }
  if (failed.category() == http::make_error_code(http::error::bad_method).category()) {
    return problem(400, "malformed", "The request is not readable HTTP.");
  }
  return std::nullopt;
}

// One browser's connection. Its members are used on its strand only.
template <class Stream>
class Connection : public std::enable_shared_from_this<Connection<Stream>> {
 public:
  Connection(Stream stream, Service& service, std::string peer)
      : stream_(std::move(stream)),
        service_(service),
        peer_(std::move(peer)),
        counted_(count_connection(service)) {}

  void start() {
    if constexpr (std::is_same_v<Stream, TlsStream>) {
      limit_time();
      stream_.async_handshake(ssl::stream_base::server,
                              [self = this->shared_from_this()](auto failed) {
                                if (!failed) self->read_header();
                              });
    } else {
      net::dispatch(stream_.get_executor(),
                    [self = this->shared_from_this()] { self->read_header(); });
    }
  }

 private:
  void limit_time() {
    beast::get_lowest_layer(stream_).expires_after(
        std::chrono::duration_cast<std::chrono::milliseconds>(
            std::chrono::duration<double>(service_.site.options.request_timeout_s)));
  }

  void read_header() {
    parser_.emplace();
    parser_->header_limit(kHeaderLimit);
    parser_->body_limit(kLargestBody);
    limit_time();
    http::async_read_header(stream_, buffer_, *parser_,
                            [self = this->shared_from_this()](auto failed, std::size_t) {
                              if (failed) return self->give_up(failed);
                              self->judge_header();
                            });
  }

  // Refuses what need not be read to the end.
  void judge_header() {
    const auto& message = parser_->get();
    head_ = message.method() == http::verb::head;
    request_ = Request{};
    for (const auto& field : message) {
      request_.headers.emplace(lower(field.name_string()), std::string(field.value()));
    }
    request_.client = client_of(request_, peer_, service_.site.options);
    const auto method = method_of(message.method());
    if (!read_target(std::string(message.target()), request_)) {
      return refuse(problem(400, "malformed", "The address of the request is not readable."));
    }
    if (!is_own_host(request_.header("host"), service_.site.options)) {
      return refuse(problem(421, "wrong_host", "This server does not answer to that name."));
    }
    if (!method) {
      return refuse(problem(405, "wrong_method", "This address does not answer to that method."));
    }
    request_.method = *method;
    if (request_.path.starts_with("/api") &&
        !service_.site.requests.admit(request_.client, steady_seconds())) {
      return refuse(problem(429, "too_many", "Too many requests; wait a few seconds."));
    }
    if (beast::websocket::is_upgrade(message)) return admit_live();
    read_body();
  }

  void read_body() {
    const std::size_t limit = service_.router.body_limit(request_.method, request_.path);
    const auto length = parser_->content_length();
    if (length && *length > limit) return give_up(http::error::body_limit);
    parser_->body_limit(limit);
    http::async_read(stream_, buffer_, *parser_,
                     [self = this->shared_from_this()](auto failed, std::size_t) {
                       if (failed) return self->give_up(failed);
                       self->request_.body = std::move(self->parser_->get().body());
                       self->answer();
                     });
  }

  void answer() {
    beast::get_lowest_layer(stream_).expires_never();  // the answer may take its time
    const LaneKind kind = service_.router.lane(request_.method, request_.path);
    Lane& lane = kind == LaneKind::slow ? service_.slow : service_.quick;
    const bool keep_alive = parser_->get().keep_alive();
    const bool posted = lane.post([self = this->shared_from_this(), keep_alive](auto& store) {
      // shared: carried to the strand
      auto response =
          std::make_shared<Response>(self->service_.router.answer(self->request_, store));
      net::post(self->stream_.get_executor(),
                [self, response, keep_alive] { self->write(std::move(*response), keep_alive); });
    });
    if (!posted) write(busy(), keep_alive);
  }

  void admit_live() {
    beast::get_lowest_layer(stream_).expires_never();
    const bool posted = service_.quick.post([self = this->shared_from_this()](auto& store) {
      auto admission =
          std::make_shared<LiveAdmission>(self->service_.router.admit_live(self->request_, store));
      net::post(self->stream_.get_executor(), [self, admission] { self->enter_live(*admission); });
    });
    if (!posted) refuse(busy());
  }

  void enter_live(LiveAdmission& admission) {
    if (!admission.refusal && !service_.site.live.runs(admission.trial_id)) {
      admission.refusal =
          problem(404, "not_found", "This trial is not running any more; open its debrief.");
    }
    if (admission.refusal) return refuse(*std::move(admission.refusal));
    LiveDoor door;
    door.trials = &service_.site.live;
    door.trial_id = admission.trial_id;
    door.may_steer = admission.may_steer;
    door.connection = std::move(counted_);
    door.recheck = [&service = service_, request = request_](std::function<void(bool)> tell) {
      service.quick.post([&service, request, tell = std::move(tell)](auto& store) {
        tell(!service.router.admit_live(request, store).refusal);
      });
    };
    open_live_socket(std::move(stream_), parser_->release(), std::move(door));
  }

  static Response busy() {
    Response response = problem(503, "busy", "The server is busy; try again in a few seconds.");
    response.headers.emplace_back("Retry-After", "2");
    return response;
  }

  void give_up(beast::error_code failed) {
    if (auto response = parse_problem(failed)) return refuse(*std::move(response));
    close();
  }

  void refuse(Response response) { write(std::move(response), false); }

  void write(Response response, bool keep_alive) {
    const ServerOptions& options = service_.site.options;
    add_security_headers(response, options.tls() || options.behind_proxy);
    answer_ = {};
    answer_.version(11);
    answer_.result(static_cast<unsigned>(response.status));
    answer_.set(http::field::content_type, response.type);
    for (const auto& [name, value] : response.headers) answer_.insert(name, value);
    answer_.keep_alive(keep_alive);
    const bool has_body = response.status != 204 && response.status != 304;
    if (has_body) answer_.content_length(response.body.size());
    if (has_body && !head_) answer_.body() = std::move(response.body);
    limit_time();
    http::async_write(stream_, answer_,
                      [self = this->shared_from_this(), keep_alive](auto failed, std::size_t) {
                        if (failed) return;
                        if (keep_alive) return self->read_header();
                        self->linger();
                      });
  }

  // Closing while the client still sends would throw our answer away with its bytes: stop sending,
  // and listen for a moment.
  void linger() {
    beast::error_code ignored;
    beast::get_lowest_layer(stream_).socket().shutdown(tcp::socket::shutdown_send, ignored);
    beast::get_lowest_layer(stream_).expires_after(kLinger);
    discard(kLargestBody);
  }

  void discard(std::size_t left) {
    buffer_.consume(buffer_.size());
    beast::get_lowest_layer(stream_).async_read_some(
        buffer_.prepare(4096),
        [self = this->shared_from_this(), left](auto failed, std::size_t bytes) {
          if (!failed && bytes < left) self->discard(left - bytes);
        });
  }

  void close() {
    beast::error_code ignored;
    beast::get_lowest_layer(stream_).socket().shutdown(tcp::socket::shutdown_send, ignored);
  }

  Stream stream_;
  Service& service_;
  std::string peer_;
  std::shared_ptr<void> counted_;  // shared: goes on to the live socket
  beast::flat_buffer buffer_{kHeaderLimit + kLargestBody};
  std::optional<http::request_parser<http::string_body>> parser_;
  http::response<http::string_body> answer_;
  Request request_;
  bool head_ = false;
};

std::string peer_of(const tcp::socket& socket) {
  boost::system::error_code failed;
  const auto peer = socket.remote_endpoint(failed);
  return failed ? "unknown" : peer.address().to_string();
}

base::Error cannot_listen(const ServerOptions& options, const std::string& why) {
  return {base::ErrorCode::unavailable, "Cannot listen on " + options.address + ":" +
                                            std::to_string(options.port) + " (" + why +
                                            "); choose another port with --port."};
}

}  // namespace

struct HttpServer::Parts {
  Parts(Site& site, const Router& router, Lane& quick, Lane& slow)
      : service{site, router, quick, slow} {}

  base::Status open_tls() {
    const ServerOptions& options = service.site.options;
    if (!options.tls()) return base::Done{};
    boost::system::error_code failed;
    tls.emplace(ssl::context::tls_server);
    tls->set_options(ssl::context::default_workarounds | ssl::context::no_tlsv1 |
                     ssl::context::no_tlsv1_1);
    tls->use_certificate_chain_file(options.tls_certificate.string(), failed);
    if (!failed) tls->use_private_key_file(options.tls_key.string(), ssl::context::pem, failed);
    if (!failed) return base::Done{};
    return base::Error{base::ErrorCode::invalid_input,
                       "The TLS certificate or key cannot be read (" + failed.message() +
                           "); give both --tls-cert and --tls-key as PEM files."};
  }

  base::Status open_acceptor() {
    const ServerOptions& options = service.site.options;
    boost::system::error_code failed;
    const std::string name = options.address == "localhost" ? "127.0.0.1" : options.address;
    const auto address = net::ip::make_address(name, failed);
    if (failed) {
      return base::Error{base::ErrorCode::invalid_input,
                         "\"" + options.address + "\" is not an IP address."};
    }
    acceptor.emplace(*io);
    const tcp::endpoint endpoint(address, options.port);
    acceptor->open(endpoint.protocol(), failed);
    if (!failed) acceptor->set_option(net::socket_base::reuse_address(true), failed);
    if (!failed) acceptor->bind(endpoint, failed);
    if (!failed) acceptor->listen(net::socket_base::max_listen_connections, failed);
    if (failed) return cannot_listen(options, failed.message());
    port = acceptor->local_endpoint().port();
    return base::Done{};
  }

  void accept_next() {
    acceptor->async_accept(net::make_strand(*io), [this](auto failed, tcp::socket socket) {
      if (failed == net::error::operation_aborted || !acceptor->is_open()) return;
      if (!failed) welcome(std::move(socket));
      accept_next();
    });
  }

  void welcome(tcp::socket socket) {
    // beyond the limit the door stays shut: whoever is inside goes on undisturbed
    if (service.connections >= service.site.options.max_connections) return;
    boost::system::error_code ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    const std::string peer = peer_of(socket);
    PlainStream stream(std::move(socket));
    if (tls) {
      start(TlsStream(std::move(stream), *tls), peer);
    } else {
      start(std::move(stream), peer);
    }
  }

  template <class Stream>
  void start(Stream stream, const std::string& peer) {
    // shared: with the operations under way on it
    std::make_shared<Connection<Stream>>(std::move(stream), service, peer)->start();
  }

  // A handler that throws must not take the other connections with it.
  void run() {
    for (;;) {
      try {
        io->run();
        return;
      } catch (const std::exception& exception) {
        spdlog::error("connection: {}", exception.what());
      }
    }
  }

  Service service;
  std::optional<ssl::context> tls;
  std::unique_ptr<net::io_context> io = std::make_unique<net::io_context>(kThreads);
  std::optional<tcp::acceptor> acceptor;
  std::vector<std::thread> threads;
  std::uint16_t port = 0;
};

HttpServer::HttpServer(Site& site, const Router& router, Lane& quick, Lane& slow)
    : parts_(std::make_unique<Parts>(site, router, quick, slow)) {}

HttpServer::~HttpServer() { stop(); }

base::Status HttpServer::listen() {
  const auto secured = parts_->open_tls();
  if (!secured) return secured.error();
  const auto opened = parts_->open_acceptor();
  if (!opened) return opened.error();
  parts_->accept_next();
  for (int i = 0; i < kThreads; ++i) {
    parts_->threads.emplace_back([parts = parts_.get()] { parts->run(); });
  }
  return base::Done{};
}

void HttpServer::stop_accepting() {
  if (!parts_->acceptor || parts_->threads.empty()) return;
  net::post(*parts_->io, [parts = parts_.get()] {
    boost::system::error_code ignored;
    parts->acceptor->close(ignored);
  });
}

void HttpServer::stop() {
  if (!parts_->io) return;
  parts_->io->stop();
  for (std::thread& thread : parts_->threads) thread.join();
  parts_->threads.clear();
  parts_->acceptor.reset();
  parts_->io.reset();  // destroys the connections
}

std::uint16_t HttpServer::port() const { return parts_->port; }

}  // namespace app
