#include "tests/app/server_fixture.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <utility>  // Boost 1.74 under C++20 needs it first

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <sys/socket.h>

#include "app/server/passwords.h"
#include "app/session/publish_library.h"
#include "curricula/catalogue.h"
#include "database/curricula.h"
#include "database/trials.h"

namespace app::test {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace net = boost::asio;
using tcp = net::ip::tcp;

tcp::socket connect(net::io_context& io, std::uint16_t port) {
  tcp::socket socket(io);
  socket.connect({net::ip::address_v4::loopback(), port});
  // a server that does not answer must fail the test, not hang it
  const timeval limit{10, 0};
  setsockopt(socket.native_handle(), SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
  return socket;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::filesystem::path fresh_folder() {
  std::string name = (std::filesystem::temp_directory_path() / "cathedra-server-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  return name;
}

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

template <class T>
T checked(base::Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return *std::move(result);
}

}  // namespace

std::string Answer::header(const std::string& name) const {
  const auto found = headers.find(name);
  return found == headers.end() ? std::string{} : found->second;
}

nlohmann::json Answer::json() const { return nlohmann::json::parse(body, nullptr, false); }

Answer Client::send(const std::string& method, const std::string& target, const std::string& body,
                    const Headers& more) {
  net::io_context io;
  tcp::socket socket = connect(io, port_);
  http::request<http::string_body> request;
  request.method_string(method);
  request.target(target);
  request.set(http::field::host, "127.0.0.1:" + std::to_string(port_));
  request.set(http::field::connection, "close");
  if (!cookie.empty()) request.set(http::field::cookie, cookie);
  if (!csrf.empty()) request.set("X-CSRF-Token", csrf);
  if (!body.empty()) request.set(http::field::content_type, "application/json");
  for (const auto& [name, value] : more) request.set(name, value);
  request.body() = body;
  request.prepare_payload();
  beast::error_code failed;
  http::write(socket, request, failed);  // a server that refuses early closes before the end

  beast::flat_buffer buffer;
  http::response_parser<http::string_body> parser;
  parser.body_limit(64 * 1024 * 1024);
  if (method == "HEAD") parser.skip(true);
  http::read(socket, buffer, parser);
  Answer answer;
  answer.status = parser.get().result_int();
  answer.body = parser.get().body();
  for (const auto& field : parser.get()) {
    answer.headers.emplace(lower(std::string(field.name_string())), std::string(field.value()));
  }
  return answer;
}

Answer Client::post(const std::string& target, const nlohmann::json& body) {
  return send("POST", target, body.dump());
}

void Client::sign_in(const std::string& name) {
  const Answer answer = post("/api/session", {{"name", name}, {"password", kPassword}});
  if (answer.status != 200) throw std::runtime_error(name + " cannot sign in: " + answer.body);
  const std::string set = answer.header("set-cookie");
  cookie = set.substr(0, set.find(';'));
  csrf = answer.json().at("csrf").get<std::string>();
}

std::string send_raw(std::uint16_t port, const std::string& bytes) {
  net::io_context io;
  tcp::socket socket = connect(io, port);
  beast::error_code ignored;
  net::write(socket, net::buffer(bytes), ignored);
  std::string received;
  net::read(socket, net::dynamic_buffer(received), ignored);
  return received;
}

Workplace::Workplace() : folder(fresh_folder()) {
  store_ = checked(database::Store::open("sqlite:" + (folder / "t.db").string()));
  checked(publish_library(*store_, library()));
  const std::string phc = checked(hash_password(kPassword));
  using database::Role;
  const auto add = [&](const char* name, Role role, std::vector<std::string> groups) {
    database::NewPerson person;
    person.name = name;
    person.display_name = std::string("The ") + name;
    person.role = role;
    person.password_phc = phc;
    person.groups = std::move(groups);
    checked(database::add_person(*store_, person, "system"));
  };
  add("ann", Role::trainee, {"A"});
  add("ben", Role::trainee, {"B"});
  add("ina", Role::instructor, {"A"});
  add("ada", Role::administrator, {});
  add("rex", Role::researcher, {});
  database::NewPerson published;
  published.name = "no.1";
  published.display_name = "No.1";
  published.kind = database::PersonKind::published;
  checked(database::add_person(*store_, published, "system"));

  write_file(folder / "web/index.html",
             "<!doctype html><meta name=\"csp-nonce\" content=\"__CSP_NONCE__\"><title>C</title>");
  write_file(folder / "web/assets/app.js", "export const answer = 42;\n");
  write_file(folder / "web/icon.svg", "<svg/>");
  write_file(folder / "secret.txt", "not for the web\n");
}

Workplace::~Workplace() {
  store_.reset();
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
}

ServerOptions Workplace::options() const {
  ServerOptions options;
  options.port = 0;
  options.database_url = "sqlite:" + (folder / "t.db").string();
  options.web_root = folder / "web";
  options.build_scenes_ahead = false;
  return options;
}

curricula::Library Workplace::library() const {
  return checked(curricula::load_library(CATHEDRA_SOURCE_DIR "/curricula"));
}

std::string Workplace::id_of(const std::string& name) {
  return checked(database::person_by_name(*store_, name)).id;
}

std::string Workplace::add_trial(const std::string& name) {
  database::NewTrial trial;
  trial.id = database::new_id();
  trial.person_id = id_of(name);
  trial.enrolment_id = checked(database::enrol(*store_, trial.person_id, "vascular-basics"));
  trial.exercise_id = "linear";
  trial.exercise_version_id =
      checked(database::current_exercise(*store_, "vascular-basics", "linear")).id;
  trial.apparatus = "cathedra";
  trial.device = "keyboard";
  checked(database::begin_trial(*store_, trial));
  database::FinishedTrial finished;
  finished.end_reason = assessment::EndReason::completed;
  finished.metrics = {{"time_s", 1, 80.0}, {"force_max_n", 1, 0.4}};
  finished.verdict.outcome = assessment::Outcome::passed;
  finished.verdict.sentence = "Passed.";
  finished.rule_version = "linear@1";
  checked(database::finish_trial(*store_, trial.id, finished, {}, {}));
  return trial.id;
}

namespace {

ServerOptions changed(ServerOptions options, void (*change)(ServerOptions&)) {
  if (change != nullptr) change(options);
  return options;
}

}  // namespace

RunningServer::RunningServer(void (*change)(ServerOptions&))
    : server(changed(workplace.options(), change), workplace.library()) {
  const auto started = server.start();
  if (!started) throw std::runtime_error(started.error().message);
}

Client RunningServer::client_of(const std::string& name) const {
  Client client(server.port());
  client.sign_in(name);
  return client;
}

}  // namespace app::test
