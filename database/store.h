// The store: one SQLite file, opened by URL ("sqlite:PATH"). The only module that speaks SQL.
//
// A Store owns one connection and is used by one thread at a time; open another for another
// thread. Opening creates the file and brings its schema up to date.
//
// Every function that writes does so in one immediate transaction: it happens whole or not at
// all. Failures of the disk come back as Error{unavailable} with a sentence for the screen.
#pragma once

#include <memory>
#include <string>

#include "sim/base/result.h"

namespace database {

class Store {
 public:
  // Opens and migrates. Fails with invalid_input (URL; postgresql: is not supported yet),
  // unavailable (disk, permissions, locked) or corrupt_data (not a Cathedra database, or written
  // by a newer program).
  static base::Result<std::unique_ptr<Store>> open(const std::string& url);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  int schema_version() const;
  // PRAGMA integrity_check and foreign_key_check; a sentence when something is wrong.
  base::Status check_integrity();

  struct Connection;  // SOCI session, known to database/*.cpp only
  Connection& connection() { return *connection_; }

 private:
  explicit Store(std::unique_ptr<Connection> connection);
  std::unique_ptr<Connection> connection_;
};

// Now, UTC, ISO 8601 with milliseconds and Z: sorting such texts sorts by time.
std::string utc_now();
// A new UUIDv7; ids made in a later millisecond sort later.
std::string new_id();

}  // namespace database
