// The audit log: a hash chain of who changed what. Rows are added by the functions that make the
// change, in the same transaction. They name people by id and hold no text about them: only
// hashes of the object before and after.
//
//     row n:  seq utc actor action object before_hash after_hash prev_hash | hash
//     row n+1:                                                   prev_hash = hash of row n
//     head:   seq and hash of the last row
//
// A row that was changed, removed or moved breaks the chain; rows removed at the end no longer
// reach the head. What the chain alone cannot show is a log that was rewritten as a whole, all
// hashes and the head included: compare audit_head() with a copy kept elsewhere for that.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "database/store.h"

namespace database {

struct AuditRow {
  std::int64_t seq = 0;
  std::string utc, actor, action, object, before_hash, after_hash, prev_hash;
  std::string hash;  // of all the fields above, SHA-256, hex
};

// The newest first; with `before`, of the rows numbered lower than that.
base::Result<std::vector<AuditRow>> audit_log(Store& store, int limit, int before = 0);
// For what changes no row of the store: a backup made or taken away. `content` is kept as a hash.
base::Status note_in_audit(Store& store, const std::string& actor, const std::string& action,
                           const std::string& object, const std::string& content);
base::Result<std::string> audit_head(Store& store);  // "SEQ HASH" of the last row, to be kept apart
// Fails with corrupt_data naming the first row that was changed, removed or reordered.
base::Status verify_audit(Store& store);

}  // namespace database
