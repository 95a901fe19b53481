#include "tests/database/raw_file.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

namespace database_test {

RawFile::RawFile(const std::string& path) {
  EXPECT_EQ(sqlite3_open(path.c_str(), &handle_), SQLITE_OK);
  sqlite3_busy_timeout(handle_, 5000);
}

RawFile::~RawFile() { sqlite3_close(handle_); }

int RawFile::try_run(const std::string& statements) {
  return sqlite3_exec(handle_, statements.c_str(), nullptr, nullptr, nullptr);
}

void RawFile::run(const std::string& statements) {
  EXPECT_EQ(try_run(statements), SQLITE_OK) << statements << ": " << sqlite3_errmsg(handle_);
}

std::vector<std::string> RawFile::rows(const std::string& query) {
  std::vector<std::string> result;
  const auto take = [](void* to, int count, char** values, char**) {
    std::string row;
    for (int i = 0; i < count; ++i) {
      row += (i > 0 ? "|" : "") + std::string(values[i] != nullptr ? values[i] : "NULL");
    }
    static_cast<std::vector<std::string>*>(to)->push_back(row);
    return 0;
  };
  EXPECT_EQ(sqlite3_exec(handle_, query.c_str(), take, &result, nullptr), SQLITE_OK)
      << query << ": " << sqlite3_errmsg(handle_);
  return result;
}

std::string RawFile::value(const std::string& query) {
  const std::vector<std::string> result = rows(query);
  return result.empty() ? "" : result.front();
}

}  // namespace database_test
