#include "database/migrate.h"

#include <string>

#include "database/migrations.h"

namespace database {
namespace {

// "CATH" in the file's header marks it as ours, for us and for file(1).
constexpr int kApplicationId = 0x43415448;

int application_id(soci::session& sql) {
  int id = 0;
  sql << "PRAGMA application_id", soci::into(id);
  return id;
}

bool is_empty(soci::session& sql) {
  int objects = 0;
  sql << "SELECT count(*) FROM sqlite_master", soci::into(objects);
  return objects == 0;
}

int stored_version(soci::session& sql) {
  int version = 0;
  sql << "SELECT coalesce(max(version), 0) FROM schema_migration", soci::into(version);
  return version;
}

void apply(Store::Connection& connection, const Migration& migration) {
  run_script(connection, migration.sql);
  execute(connection.sql,
          "INSERT INTO schema_migration (version, name, applied_utc) "
          "VALUES (:version, :name, :utc)",
          migration.version, std::string(migration.name), utc_now());
}

}  // namespace

base::Status check_ownership(Store::Connection& connection) {
  if (application_id(connection.sql) == kApplicationId || is_empty(connection.sql)) {
    return base::Done{};
  }
  return base::Error{base::ErrorCode::corrupt_data,
                     "The file is a database of another program, not of Cathedra."};
}

base::Result<int> migrate(Store::Connection& connection) {
  Transaction transaction(connection, Transaction::Kind::writing);
  // asked again under the lock: another program may have created it in the meantime
  int version = 0;
  if (is_empty(connection.sql)) {
    run_script(connection, ("PRAGMA application_id = " + std::to_string(kApplicationId)).c_str());
  } else {
    version = stored_version(connection.sql);
  }
  const int newest = migrations().back().version;
  if (version > newest) {
    return base::Error{base::ErrorCode::corrupt_data,
                       "The database has schema " + std::to_string(version) +
                           ", and this program knows schemas up to " + std::to_string(newest) +
                           " only; install the newer version of Cathedra that wrote it."};
  }
  for (const Migration& migration : migrations()) {
    if (migration.version > version) apply(connection, migration);
  }
  transaction.commit();
  return newest;
}

}  // namespace database
