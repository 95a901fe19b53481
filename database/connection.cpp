#include "database/connection.h"

namespace database {
namespace {

using base::Error;
using base::ErrorCode;

// What broke, in words for the person at the screen. `code` may be an extended result code.
Error constraint_error(int code, const std::string& detail) {
  switch (code) {
    case SQLITE_CONSTRAINT_UNIQUE:
    case SQLITE_CONSTRAINT_PRIMARYKEY:
    case SQLITE_CONSTRAINT_ROWID:
      return {ErrorCode::conflict, "This is already stored: " + detail + "."};
    case SQLITE_CONSTRAINT_FOREIGNKEY:
      return {ErrorCode::not_found, "This refers to a record that does not exist."};
    default:
      return {ErrorCode::invalid_input, "The store refused a value: " + detail + "."};
  }
}

Error error_of_code(int code, const std::string& detail) {
  switch (code & 0xff) {
    case SQLITE_FULL:
      return {ErrorCode::unavailable,
              "The disk is full; nothing was written. Free some space and try again."};
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
      return {ErrorCode::unavailable,
              "The database may only be read; give the program the right to write to its file "
              "and folder."};
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return {ErrorCode::unavailable,
              "The database is locked by another program; try again in a moment."};
    case SQLITE_CANTOPEN:
      return {ErrorCode::unavailable,
              "The database file cannot be opened; check that its folder exists and that the "
              "program may write there."};
    case SQLITE_IOERR:
      return {ErrorCode::unavailable, "The disk failed while the database was used (" + detail +
                                          "); nothing was written. Check the disk and try again."};
    case SQLITE_CORRUPT:
      return {ErrorCode::corrupt_data,
              "The database file is damaged (" + detail + "); restore a backup."};
    case SQLITE_NOTADB:
      return {ErrorCode::corrupt_data, "The file is not a Cathedra database."};
    case SQLITE_TOOBIG:
      return {ErrorCode::invalid_input, "A value is too large to be stored."};
    case SQLITE_CONSTRAINT:
    case SQLITE_MISMATCH:
      return constraint_error(code, detail);
    default:
      return {ErrorCode::unavailable, "The database failed: " + detail + "."};
  }
}

}  // namespace

sqlite_api::sqlite3* Store::Connection::native() {
  return static_cast<soci::sqlite3_session_backend*>(sql.get_backend())->conn_;
}

Transaction::Transaction(Store::Connection& connection, Kind kind) : connection_(connection) {
  connection_.sql << (kind == Kind::writing ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction() {
  // a full disk may already have ended the transaction, and then there is nothing to undo
  sqlite_api::sqlite3* native = connection_.native();
  if (sqlite_api::sqlite3_get_autocommit(native) == 0) {
    sqlite_api::sqlite3_exec(native, "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

void Transaction::commit() { connection_.sql << "COMMIT"; }

Error error_from(const std::exception& exception) {
  if (const auto* failure = dynamic_cast<const soci::sqlite3_soci_error*>(&exception)) {
    return error_of_code(failure->result(), failure->get_error_message());
  }
  return {ErrorCode::unavailable, std::string("The database failed: ") + exception.what() + "."};
}

void check_sqlite(Store::Connection& connection, int code) {
  if (code == SQLITE_OK || code == SQLITE_DONE || code == SQLITE_ROW) return;
  throw soci::sqlite3_soci_error(sqlite_api::sqlite3_errmsg(connection.native()), code);
}

void run_script(Store::Connection& connection, const char* statements) {
  check_sqlite(connection, sqlite_api::sqlite3_exec(connection.native(), statements, nullptr,
                                                    nullptr, nullptr));
}

int changed_rows(Store::Connection& connection) {
  return sqlite_api::sqlite3_changes(connection.native());
}

}  // namespace database
