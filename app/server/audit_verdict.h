// Is the chain of the audit log whole? Walking it takes a while on an old site, so the verdict is
// kept until the log grows, and for a minute at most: a changed row in the middle moves no head.
// May be used from several threads.
#pragma once

#include <mutex>
#include <string>

#include "database/store.h"

namespace app {

class AuditVerdict {
 public:
  struct Verdict {
    bool intact = false;
    std::string sentence;
  };
  // `now`: steady_seconds().
  base::Result<Verdict> look(database::Store& store, double now);

 private:
  std::mutex mutex_;
  std::string head_;  // empty: never looked
  double looked_s_ = 0.0;
  Verdict verdict_;
};

}  // namespace app
