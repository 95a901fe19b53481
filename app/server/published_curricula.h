// The curricula people train by, each in its newest published version, read from its stored text
// and kept. May be used from several threads.
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
  using Found = base::Result<std::shared_ptr<const curricula::Curriculum>>;  // shared: callers

  // Each fails with not_found when none is published, corrupt_data when its text does not pass
  // the checker any more.
  Found of_person(database::Store& store, const curricula::Catalogue& catalogue,
                  const std::string& person_id);
  // What people train by who are assigned nothing else.
  Found standard(database::Store& store, const curricula::Catalogue& catalogue);
  Found by_id(database::Store& store, const curricula::Catalogue& catalogue,
              const std::string& curriculum_id);

 private:
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const curricula::Curriculum>> by_hash_;  // shared: callers
};

}  // namespace app
