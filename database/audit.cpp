#include "database/audit.h"

#include <array>

#include <sodium.h>

#include "database/audit_chain.h"
#include "database/connection.h"

namespace database {
namespace {

using base::Error;
using base::ErrorCode;

struct Head {
  int seq = 0;
  std::string hash;
};

Head read_head(soci::session& sql) {
  Head head;
  sql << "SELECT seq, hash FROM audit_head WHERE one = 1", soci::into(head.seq),
      soci::into(head.hash);
  return head;
}

std::string hash_of_row(const AuditRow& row) {
  return hash_of({std::to_string(row.seq), row.utc, row.actor, row.action, row.object,
                  row.before_hash, row.after_hash, row.prev_hash});
}

// Rows by the given condition and order, handed to `take` one by one.
template <typename Take>
void read_rows(soci::session& sql, const std::string& which, Take take) {
  AuditRow row;
  int seq = 0;
  soci::statement select =
      (sql.prepare << "SELECT seq, utc, actor, action, object, before_hash, after_hash, "
                      "prev_hash, hash FROM audit " +
                          which,
       soci::into(seq), soci::into(row.utc), soci::into(row.actor), soci::into(row.action),
       soci::into(row.object), soci::into(row.before_hash), soci::into(row.after_hash),
       soci::into(row.prev_hash), soci::into(row.hash));
  select.execute();
  while (select.fetch()) {
    row.seq = seq;
    take(row);
  }
}

Error broken(const std::string& what) { return {ErrorCode::corrupt_data, what}; }

std::string name_of(const AuditRow& row) {
  return "Audit row " + std::to_string(row.seq) + " (" + row.utc + ", " + row.action + ")";
}

// What is wrong with `row` as the one after `previous`; none when it fits.
base::Status check_link(const AuditRow& previous, const AuditRow& row) {
  if (row.seq != previous.seq + 1) {
    return broken("Audit row " + std::to_string(previous.seq + 1) + " was removed.");
  }
  if (hash_of_row(row) != row.hash) return broken(name_of(row) + " was changed or moved.");
  if (row.prev_hash != previous.hash) {
    return broken(name_of(row) + " does not follow the row before it: row " +
                  std::to_string(previous.seq) + " was changed, replaced or moved.");
  }
  return base::Done{};
}

}  // namespace

std::string hash_of(const std::vector<std::string>& fields) {
  std::string canonical;
  for (const std::string& field : fields) {
    canonical += std::to_string(field.size()) + ":" + field;
  }
  std::array<unsigned char, crypto_hash_sha256_BYTES> digest{};
  crypto_hash_sha256(digest.data(), reinterpret_cast<const unsigned char*>(canonical.data()),
                     canonical.size());
  std::array<char, 2 * crypto_hash_sha256_BYTES + 1> hex{};
  sodium_bin2hex(hex.data(), hex.size(), digest.data(), digest.size());
  return hex.data();
}

void add_audit(soci::session& sql, const AuditEntry& entry) {
  const Head head = read_head(sql);
  AuditRow row;
  row.seq = head.seq + 1;
  row.utc = utc_now();
  row.actor = entry.actor;
  row.action = entry.action;
  row.object = entry.object;
  row.before_hash = entry.before_hash;
  row.after_hash = entry.after_hash;
  row.prev_hash = head.hash;
  row.hash = hash_of_row(row);
  const int seq = head.seq + 1;
  execute(sql,
          "INSERT INTO audit (seq, utc, actor, action, object, before_hash, after_hash, prev_hash, "
          "hash) VALUES (:seq, :utc, :actor, :action, :object, :before, :after, :prev, :hash)",
          seq, row.utc, row.actor, row.action, row.object, row.before_hash, row.after_hash,
          row.prev_hash, row.hash);
  execute(sql, "UPDATE audit_head SET seq = :seq, hash = :hash WHERE one = 1", seq, row.hash);
}

base::Result<std::vector<AuditRow>> audit_log(Store& store, int limit, int before) {
  return reading(store, [&](soci::session& sql) -> base::Result<std::vector<AuditRow>> {
    std::vector<AuditRow> rows;
    if (limit <= 0) return rows;
    const std::string older = before > 0 ? "WHERE seq < " + std::to_string(before) + " " : "";
    read_rows(sql, older + "ORDER BY seq DESC LIMIT " + std::to_string(limit),
              [&](const AuditRow& row) { rows.push_back(row); });
    return rows;
  });
}

base::Status note_in_audit(Store& store, const std::string& actor, const std::string& action,
                           const std::string& object, const std::string& content) {
  return writing(store, [&](soci::session& sql) -> base::Status {
    add_audit(sql, {actor, action, object, "", hash_of({content})});
    return base::Done{};
  });
}

base::Result<std::string> audit_head(Store& store) {
  return reading(store, [](soci::session& sql) -> base::Result<std::string> {
    const Head head = read_head(sql);
    return std::to_string(head.seq) + " " + head.hash;
  });
}

base::Status verify_audit(Store& store) {
  return reading(store, [](soci::session& sql) -> base::Status {
    AuditRow previous;
    base::Status verdict = base::Done{};
    read_rows(sql, "ORDER BY seq", [&](const AuditRow& row) {
      if (verdict) verdict = check_link(previous, row);
      previous = row;
    });
    if (!verdict) return verdict;
    const Head head = read_head(sql);
    if (head.seq > previous.seq) {
      return broken("Audit row " + std::to_string(previous.seq + 1) +
                    " was removed, with all rows after it.");
    }
    if (head.seq < previous.seq) {
      return broken("Audit row " + std::to_string(head.seq + 1) +
                    " was added by something else than Cathedra.");
    }
    if (head.hash != previous.hash) return broken(name_of(previous) + " was replaced.");
    return base::Done{};
  });
}

}  // namespace database
