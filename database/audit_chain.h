// Adds rows to the audit log. For database/*.cpp only, inside the transaction of the change.
#pragma once

#include <string>
#include <vector>

#include <soci/soci.h>

namespace database {

struct AuditEntry {
  std::string actor, action, object;  // object: "person:ID", "trial:ID", ...
  std::string before_hash;            // of the object's fields; empty: it was not there
  std::string after_hash;
};

void add_audit(soci::session& sql, const AuditEntry& entry);

// SHA-256, hex, of fields each written as LENGTH:BYTES, so that no two lists of fields look alike.
std::string hash_of(const std::vector<std::string>& fields);

}  // namespace database
