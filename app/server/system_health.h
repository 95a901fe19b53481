// What an administrator should know before it hurts: each check with a state and one sentence.
#pragma once

#include <string>
#include <vector>

#include "app/server/backup_folder.h"
#include "app/server/site.h"

namespace app {

struct HealthCheck {
  std::string what;
  const char* state = "ok";  // ok, warn, bad
  std::string sentence;
};

base::Result<std::vector<HealthCheck>> system_health(Site& site, database::Store& store,
                                                     const std::vector<BackupFile>& backups);

// The two that depend on numbers only. Bytes; times as stored.
HealthCheck disk_health(std::uintmax_t free_bytes, std::uintmax_t database_bytes);
HealthCheck backup_health(const std::vector<BackupFile>& backups, const std::string& now_utc);

}  // namespace app
