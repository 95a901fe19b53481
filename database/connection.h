// One connection to the store and the two ways to use it: reading() and writing(). Both are one
// transaction, and both turn every exception into an Error, so that none leaves this module.
// For database/*.cpp only.
#pragma once

#include <exception>
#include <string>
#include <type_traits>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "database/store.h"
#include "sim/base/result.h"

namespace database {

struct Store::Connection {
  soci::session sql;
  int schema_version = 0;

  // The handle below SOCI, for what SOCI has no words for: blobs, scripts, backups.
  sqlite_api::sqlite3* native();
};

// A transaction that is rolled back unless commit() was reached.
class Transaction {
 public:
  // A reader sees one moment of the store. A writer takes the write lock at once: one that
  // started as a reader could be refused later, in the middle of its work.
  enum class Kind { reading, writing };

  Transaction(Store::Connection& connection, Kind kind);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void commit();  // throws like any statement; the destructor then rolls back

 private:
  Store::Connection& connection_;
};

// The sentence for a failed statement, or for any other exception.
base::Error error_from(const std::exception& exception);

// Throws soci::sqlite3_soci_error unless `code` says that it worked.
void check_sqlite(Store::Connection& connection, int code);

// Runs any number of statements that take no parameters. Throws.
void run_script(Store::Connection& connection, const char* statements);

// How many rows the statement just run has changed.
int changed_rows(Store::Connection& connection);

// Runs one statement that gives no rows, with its parameters in the order they appear. SOCI's own
// `sql << ..., use(x)` runs after the temporaries of the line are gone; here they live.
template <typename... Values>
void execute(soci::session& sql, const std::string& statement, const Values&... values) {
  soci::statement prepared(sql);
  (prepared.exchange(soci::use(values)), ...);
  prepared.alloc();
  prepared.prepare(statement);
  prepared.define_and_bind();
  prepared.execute(true);
}

// body: base::Result<T>(soci::session&). A body that returns an error has written nothing.
template <typename Body>
std::invoke_result_t<Body, soci::session&> in_transaction(Store& store, Transaction::Kind kind,
                                                          Body body) {
  try {
    Transaction transaction(store.connection(), kind);
    std::invoke_result_t<Body, soci::session&> result = body(store.connection().sql);
    if (result) transaction.commit();
    return result;
  } catch (const std::exception& exception) {
    return error_from(exception);
  }
}

template <typename Body>
std::invoke_result_t<Body, soci::session&> reading(Store& store, Body body) {
  return in_transaction(store, Transaction::Kind::reading, body);
}

template <typename Body>
std::invoke_result_t<Body, soci::session&> writing(Store& store, Body body) {
  return in_transaction(store, Transaction::Kind::writing, body);
}

}  // namespace database
