// The audit log: a hash chain of who changed what. Rows are added by the functions that make the
// change, in the same transaction.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "database/store.h"

namespace database {

struct AuditRow {
  std::int64_t seq = 0;
  std::string utc, actor, action, object, before_hash, after_hash, prev_hash;
};

base::Result<std::vector<AuditRow>> audit_log(Store& store, int limit);
// Fails with corrupt_data naming the first row that was changed, removed or reordered.
base::Status verify_audit(Store& store);

}  // namespace database
