#include "app/server/router.h"

#include <algorithm>
#include <exception>
#include <string_view>
#include <utility>

#include <spdlog/spdlog.h>

#include "app/server/access.h"
#include "app/server/problem.h"
#include "app/server/same_origin.h"
#include "app/server/secrets.h"
#include "app/server/site.h"
#include "app/server/static_files.h"

namespace app {
namespace {

using Parameters = std::map<std::string, std::string>;

std::string_view next_segment(std::string_view& path) {
  const std::size_t slash = path.find('/');
  const std::string_view segment = path.substr(0, slash);
  path = slash == std::string_view::npos ? std::string_view{} : path.substr(slash + 1);
  return segment;
}

// "{id}" takes any segment, "{id}.csv" one that ends so, anything else only itself.
bool segment_matches(std::string_view pattern, std::string_view segment, Parameters& found) {
  if (pattern.empty() || pattern.front() != '{') return pattern == segment;
  const std::size_t close = pattern.find('}');
  const std::string_view ending = pattern.substr(close + 1);
  if (segment.size() <= ending.size() || !segment.ends_with(ending)) return false;
  found[std::string(pattern.substr(1, close - 1))] =
      std::string(segment.substr(0, segment.size() - ending.size()));
  return true;
}

bool path_matches(std::string_view pattern, std::string_view path, Parameters& found) {
  found.clear();
  if (path.size() > 1 && path.ends_with('/')) return false;
  while (!pattern.empty() && !path.empty()) {
    if (!segment_matches(next_segment(pattern), next_segment(path), found)) return false;
  }
  return pattern.empty() && path.empty();
}

const Route* find_route(Method method, const std::string& path, Parameters& found) {
  for (const Route& route : routes()) {
    if (route.method == method && path_matches(route.pattern, path, found)) return &route;
  }
  return nullptr;
}

std::string methods_of(const std::string& path) {
  std::string allowed;
  Parameters unused;
  for (const Route& route : routes()) {
    if (!path_matches(route.pattern, path, unused)) continue;
    if (!allowed.empty()) allowed += ", ";
    allowed += word(route.method);
  }
  return allowed;
}

Response no_such_route(const std::string& path) {
  const std::string allowed = methods_of(path);
  if (allowed.empty()) return problem(404, "not_found", "This address does not exist.");
  Response response = problem(405, "wrong_method", "This address answers only to " + allowed + ".");
  response.headers.emplace_back("Allow", allowed);
  return response;
}

bool is_api(const std::string& path) { return path == "/api" || path.starts_with("/api/"); }

// A request that has passed the gate.
struct Admitted {
  const Route* route = nullptr;
  Parameters parameters;
  std::optional<Viewer> viewer;
};

// What the request is about to do: a channel is opened across origins without asking, so that its
// page must say where it comes from.
enum class Purpose { answer, channel };

std::optional<Response> check_origin(const Route& route, Purpose purpose, const Request& request,
                                     const Site& site) {
  const bool channel = purpose == Purpose::channel;
  if (route.method == Method::get && !channel) return std::nullopt;
  if (!is_same_origin(request, site.options, channel)) {
    return problem(403, "wrong_origin", "This request does not come from this server's own page.");
  }
  return std::nullopt;
}

std::optional<Response> check_viewer(const Route& route, const Request& request,
                                     const std::optional<Viewer>& viewer) {
  if (!viewer) return problem(401, "not_signed_in", "Sign in first.");
  if (!route.who.allows(viewer->person.role)) {
    return problem(403, "denied", "Your role does not allow this.");
  }
  if (route.method != Method::get &&
      !same_secret(request.header("x-csrf-token"), viewer->csrf_token)) {
    return problem(403, "wrong_token", "The page is out of date; reload it and try again.");
  }
  return std::nullopt;
}

// Passes the gate, or says why not.
std::optional<Response> pass_gate(const Request& request, Purpose purpose, database::Store& store,
                                  Site& site, Admitted& admitted) {
  admitted.route = find_route(request.method, request.path, admitted.parameters);
  if (admitted.route == nullptr) return no_such_route(request.path);
  const Route& route = *admitted.route;
  if (auto refusal = check_origin(route, purpose, request, site)) return refusal;

  auto viewer = viewer_of(store, request, site.session_rules());
  if (!viewer) return problem(viewer.error());
  admitted.viewer = *std::move(viewer);
  if (route.who.is_public()) return std::nullopt;

  if (auto refusal = check_viewer(route, request, admitted.viewer)) return refusal;
  const auto allowed =
      check_subject(store, site, admitted.viewer->person, route.who.subject(), admitted.parameters);
  if (!allowed) return problem(allowed.error());
  return std::nullopt;
}

Response handle(const Request& request, database::Store& store, Site& site) {
  if (!is_api(request.path)) return static_file(request, site.options.web_root);
  Admitted admitted;
  if (auto refusal = pass_gate(request, Purpose::answer, store, site, admitted))
    return *std::move(refusal);
  if (admitted.route->live) {
    Response response = problem(426, "upgrade_required", "This address speaks WebSocket.");
    response.headers.emplace_back("Upgrade", "websocket");
    return response;
  }
  Call call{request, admitted.parameters, admitted.viewer, store, site};
  auto response = admitted.route->handle(call);
  return response ? *std::move(response) : problem(response.error());
}

LiveAdmission admit(const Request& request, database::Store& store, Site& site) {
  LiveAdmission admission;
  Admitted admitted;
  admission.refusal = pass_gate(request, Purpose::channel, store, site, admitted);
  if (admission.refusal) return admission;
  if (!admitted.route->live) {
    admission.refusal = problem(400, "not_live", "This address does not speak WebSocket.");
    return admission;
  }
  admission.trial_id = admitted.parameters.at("id");
  const auto running = site.live.find(admission.trial_id);
  admission.may_steer = running && running->person_id == admitted.viewer->person.id;
  return admission;
}

Response broken(const Request& request, const char* what) {
  spdlog::error("{} {}: {}", word(request.method), request.path, what);
  return problem(500, "internal", "The server failed to answer; its log says why.");
}

}  // namespace

Who Who::anyone() {
  Who who;
  who.public_ = true;
  return who;
}

Who Who::signed_in() {
  using database::Role;
  return roles({Role::trainee, Role::instructor, Role::administrator, Role::researcher});
}

Who Who::roles(std::initializer_list<database::Role> roles) {
  Who who;
  for (const database::Role role : roles) who.allowed_ |= 1U << static_cast<unsigned>(role);
  return who;
}

Who Who::about(Subject subject) const {
  Who who = *this;
  who.subject_ = subject;
  return who;
}

std::size_t Router::body_limit(Method method, const std::string& path) const {
  Parameters unused;
  const Route* route = find_route(method, path, unused);
  return route == nullptr ? Route{}.body_limit : route->body_limit;
}

LaneKind Router::lane(Method method, const std::string& path) const {
  Parameters unused;
  const Route* route = find_route(method, path, unused);
  return route == nullptr ? LaneKind::quick : route->lane;
}

Response Router::answer(const Request& request, database::Store& store) const {
  try {
    return handle(request, store, site_);
  } catch (const std::exception& exception) {
    return broken(request, exception.what());
  } catch (...) {
    return broken(request, "unknown exception");
  }
}

LiveAdmission Router::admit_live(const Request& request, database::Store& store) const {
  try {
    return admit(request, store, site_);
  } catch (const std::exception& exception) {
    return {broken(request, exception.what()), {}, false};
  } catch (...) {
    return {broken(request, "unknown exception"), {}, false};
  }
}

}  // namespace app
