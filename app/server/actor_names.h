// Who did something, in words: the audit and other records name people by id.
#pragma once

#include <map>
#include <string>

#include "database/store.h"
#include "sim/base/result.h"

namespace app {

class ActorNames {
 public:
  static base::Result<ActorNames> load(database::Store& store);

  // The display name; "the program" and "the shell" for what no person did; the id of somebody who
  // is known no more.
  std::string actor(const std::string& id) const;
  // "person:ID" becomes "person NAME", everything else "kind ID".
  std::string object(const std::string& object) const;

 private:
  std::map<std::string, std::string> by_id_;
};

}  // namespace app
