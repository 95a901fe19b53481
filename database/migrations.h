// The numbered migrations, embedded from database/migrations/*.sql when the library is built.
#pragma once

#include <span>

namespace database {

struct Migration {
  int version = 0;        // 1, 2, ... without gaps
  const char* name = "";  // 0001_start
  const char* sql = "";   // any number of statements
};

std::span<const Migration> migrations();  // by version

}  // namespace database
