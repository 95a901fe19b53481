// How much the store holds, for whoever looks after it.
#pragma once

#include <string>
#include <vector>

#include "database/store.h"

namespace database {

struct StoredCount {
  std::string what;
  int count = 0;
};

base::Result<std::vector<StoredCount>> stored_counts(Store& store);

}  // namespace database
