// SQL run by SQLite itself, without the store: to break things, and to look at what is there.
#pragma once

#include <string>
#include <vector>

struct sqlite3;

namespace database_test {

class RawFile {
 public:
  explicit RawFile(const std::string& path);
  ~RawFile();
  RawFile(const RawFile&) = delete;
  RawFile& operator=(const RawFile&) = delete;

  int try_run(const std::string& statements);               // SQLite's result code
  void run(const std::string& statements);                  // the test fails when it fails
  std::vector<std::string> rows(const std::string& query);  // columns joined by '|'
  std::string value(const std::string& query);              // the first row, or empty

 private:
  sqlite3* handle_ = nullptr;
};

}  // namespace database_test
