// The table of routes and the one gate in front of it. What is not in the table does not exist;
// whom a row does not name is refused.
//
// The gate, in this order: the route exists (404, 405) - a change comes from our own page (403) -
// somebody is signed in (401) - the role may (403) - the change carries the session's token (403)
// - the person or trial named in the path is the caller's own or in their care (404, 403).
#pragma once

#include <cstddef>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/server/message.h"
#include "app/server/sessions.h"
#include "database/store.h"
#include "sim/base/result.h"

namespace app {

struct Site;

// Whose data a route shows, by the parameter {id} of its path.
enum class Subject { nobody, person, trial, live_trial, practice };

// Who may use a route.
class Who {
 public:
  static Who anyone();     // also without signing in
  static Who signed_in();  // whatever the role
  static Who roles(std::initializer_list<database::Role> roles);
  Who about(Subject subject) const;  // of those, whoever may see this person or trial; practice
                                     // is seen by nobody but the one who practises

  bool is_public() const { return public_; }
  bool allows(database::Role role) const {
    return ((allowed_ >> static_cast<unsigned>(role)) & 1U) != 0;
  }
  Subject subject() const { return subject_; }

 private:
  bool public_ = false;
  unsigned allowed_ = 0;  // one bit per role
  Subject subject_ = Subject::nobody;
};

enum class LaneKind { quick, slow };

// A request on its way through a handler.
struct Call {
  const Request& request;
  const std::map<std::string, std::string>& parameters;  // of the path
  const std::optional<Viewer>& viewer;
  database::Store& store;
  Site& site;

  const Viewer& me() const { return *viewer; }  // on routes that are not public
  const std::string& parameter(const std::string& name) const { return parameters.at(name); }
};

struct Route {
  Method method = Method::get;
  std::string pattern;  // /api/people/{id}/progress; a segment may end in .csv after {name}
  Who who;
  base::Result<Response> (*handle)(Call&) = nullptr;
  LaneKind lane = LaneKind::quick;
  bool live = false;                                // a WebSocket
  std::size_t body_limit = std::size_t{64} * 1024;  // bytes
};

// Every route of the server, in the order they are tried.
std::span<const Route> routes();

// Admitted to a live trial, or the answer that says no.
struct LiveAdmission {
  std::optional<Response> refusal;
  std::string trial_id;
  bool may_steer = false;
};

class Router {
 public:
  explicit Router(Site& site) : site_(site) {}

  // Before the body is read: how long it may be, and which threads answer.
  std::size_t body_limit(Method method, const std::string& path) const;
  LaneKind lane(Method method, const std::string& path) const;

  // Never throws: a failure inside becomes a Problem and a line in the log.
  Response answer(const Request& request, database::Store& store) const;
  LiveAdmission admit_live(const Request& request, database::Store& store) const;

 private:
  Site& site_;
};

}  // namespace app
