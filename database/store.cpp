#include "database/store.h"

#include <chrono>
#include <thread>
#include <utility>

#include "database/connection.h"
#include "database/migrate.h"

namespace database {
namespace {

using base::Error;
using base::ErrorCode;

constexpr int kBusyTimeoutSeconds = 20;  // longer than any transaction of ours takes

base::Result<std::string> path_of(const std::string& url) {
  const std::string scheme = "sqlite:";
  if (url.rfind("postgresql:", 0) == 0 || url.rfind("postgres:", 0) == 0) {
    return Error{ErrorCode::invalid_input,
                 "This version of Cathedra supports SQLite only; use --database sqlite:PATH."};
  }
  if (url.rfind(scheme, 0) != 0 || url.size() == scheme.size()) {
    return Error{ErrorCode::invalid_input,
                 "A database is named sqlite:PATH, for example sqlite:data/cathedra.db."};
  }
  const std::string path = url.substr(scheme.size());
  // SOCI takes the path inside double quotes and knows no way to escape one
  for (const char c : path) {
    if (c == '"' || static_cast<unsigned char>(c) < 0x20) {
      return Error{ErrorCode::invalid_input,
                   "The path of a database may hold no double quotes or control characters."};
    }
  }
  return path;
}

// Switching to the write-ahead log needs the file for oneself for a moment, and SQLite does not
// wait for that by itself.
void use_write_ahead_log(Store::Connection& connection) {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(kBusyTimeoutSeconds);
  for (;;) {
    try {
      run_script(connection, "PRAGMA journal_mode = WAL");
      return;
    } catch (const soci::sqlite3_soci_error& failure) {
      const bool busy = (failure.result() & 0xff) == SQLITE_BUSY;
      if (!busy || std::chrono::steady_clock::now() > give_up) throw;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
}

base::Result<std::unique_ptr<Store::Connection>> connect(const std::string& path) {
  auto connection = std::make_unique<Store::Connection>();
  connection->sql.open(soci::sqlite3,
                       "dbname=\"" + path + "\" timeout=" + std::to_string(kBusyTimeoutSeconds));
  sqlite_api::sqlite3_extended_result_codes(connection->native(), 1);
  if (base::Status ours = check_ownership(*connection); !ours) return ours.error();
  use_write_ahead_log(*connection);
  // FULL: a trial that was reported as stored is stored, also when the power fails
  run_script(*connection, "PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON");
  base::Result<int> version = migrate(*connection);
  if (!version) return version.error();
  connection->schema_version = *version;
  return connection;
}

}  // namespace

Store::Store(std::unique_ptr<Connection> connection) : connection_(std::move(connection)) {}
Store::~Store() = default;

base::Result<std::unique_ptr<Store>> Store::open(const std::string& url) {
  const base::Result<std::string> path = path_of(url);
  if (!path) return path.error();
  try {
    base::Result<std::unique_ptr<Connection>> connection = connect(*path);
    if (!connection)
      return Error{connection.error().code, *path + ": " + connection.error().message};
    return std::unique_ptr<Store>(new Store(*std::move(connection)));
  } catch (const std::exception& exception) {
    const Error error = error_from(exception);
    return Error{error.code, *path + ": " + error.message};
  }
}

int Store::schema_version() const { return connection_->schema_version; }

base::Status Store::check_integrity() {
  return reading(*this, [](soci::session& sql) -> base::Status {
    std::string verdict;
    sql << "SELECT integrity_check FROM pragma_integrity_check LIMIT 1", soci::into(verdict);
    if (verdict != "ok") {
      return Error{ErrorCode::corrupt_data,
                   "The database file is damaged (" + verdict + "); restore a backup."};
    }
    std::string table;
    sql << "SELECT \"table\" FROM pragma_foreign_key_check LIMIT 1", soci::into(table);
    if (sql.got_data()) {
      return Error{ErrorCode::corrupt_data, "A row of the table " + table +
                                                " refers to a record that does not exist; "
                                                "restore a backup."};
    }
    return base::Done{};
  });
}

}  // namespace database
