// The curriculum people train by: the newest published one in the database, read from its stored
// text and kept until another is published. May be used from several threads.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "curricula/check.h"
#include "curricula/curriculum.h"
#include "database/store.h"
#include "sim/base/result.h"

namespace app {

class PublishedCurricula {
 public:
  // not_found when none is published yet; corrupt_data when its text does not pass the checker.
  base::Result<std::shared_ptr<const curricula::Curriculum>> current(
      database::Store& store, const curricula::Catalogue& catalogue);

 private:
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const curricula::Curriculum>> by_hash_;  // shared: callers
};

}  // namespace app
