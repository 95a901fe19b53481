#include "database/backup.h"

#include <filesystem>
#include <system_error>

#include "database/connection.h"

namespace database {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::ErrorCode;

// All pages in one step: the copy is then of one moment, and a writer in between does not make it
// begin again. Readers do not hold up writers.
base::Status copy_pages(Store::Connection& from, const std::string& path) {
  Store::Connection to;
  to.sql.open(soci::sqlite3, "dbname=\"" + path + "\"");
  sqlite_api::sqlite3_backup* copy =
      sqlite_api::sqlite3_backup_init(to.native(), "main", from.native(), "main");
  if (copy == nullptr) check_sqlite(to, sqlite_api::sqlite3_errcode(to.native()));
  sqlite_api::sqlite3_backup_step(copy, -1);
  check_sqlite(to, sqlite_api::sqlite3_backup_finish(copy));

  std::string verdict;
  to.sql << "SELECT integrity_check FROM pragma_integrity_check LIMIT 1", soci::into(verdict);
  if (verdict != "ok") {
    return Error{ErrorCode::corrupt_data,
                 "The backup was written but cannot be read back (" + verdict + ")."};
  }
  return base::Done{};
}

void remove_with_log(const std::string& path) {
  std::error_code ignored;  // what is not there need not be removed
  for (const char* suffix : {"", "-wal", "-shm", "-journal"}) fs::remove(path + suffix, ignored);
}

}  // namespace

base::Status backup(Store& store, const std::string& path) {
  std::error_code failure;
  if (fs::exists(path, failure)) {
    return Error{ErrorCode::conflict, path + " exists; choose another name for the backup."};
  }
  if (path.empty() || path.find('"') != std::string::npos) {
    return Error{ErrorCode::invalid_input,
                 "The path of a backup may not be empty or hold double quotes."};
  }
  const std::string unfinished = path + ".part";
  remove_with_log(unfinished);
  base::Status status = base::Done{};
  try {
    status = copy_pages(store.connection(), unfinished);
  } catch (const std::exception& exception) {
    status = error_from(exception);
  }
  if (status) {
    fs::rename(unfinished, path, failure);
    if (failure) {
      status = Error{ErrorCode::unavailable, "it cannot be renamed: " + failure.message() + "."};
    }
  }
  remove_with_log(unfinished);
  if (!status) {
    return Error{status.error().code, "Backup to " + path + ": " + status.error().message};
  }
  return base::Done{};
}

}  // namespace database
