#include "app/server/system_health.h"

#include <chrono>
#include <cstdio>

namespace app {
namespace {

constexpr double kFullDisk = 1e9, kNarrowDisk = 5e9;  // bytes free
constexpr int kOldBackup = 7;                         // days

std::string in_gb(std::uintmax_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f GB", static_cast<double>(bytes) / 1e9);
  return text;
}

std::chrono::sys_days day_of(const std::string& utc) {
  using namespace std::chrono;
  const auto number = [&](std::size_t at, std::size_t digits) {
    return std::stoi(utc.substr(at, digits));
  };
  return sys_days(year(number(0, 4)) / month(static_cast<unsigned>(number(5, 2))) /
                  day(static_cast<unsigned>(number(8, 2))));
}

}  // namespace

HealthCheck disk_health(std::uintmax_t free_bytes, std::uintmax_t database_bytes) {
  const std::string left = in_gb(free_bytes) + " free";
  const double free = static_cast<double>(free_bytes);
  if (free < kFullDisk) {
    return {"Disk", "bad", left + "; trials will soon not be filed. Make room now."};
  }
  if (free < kNarrowDisk || free_bytes < 2 * database_bytes) {
    return {"Disk", "warn", left + "; make room before backups no longer fit."};
  }
  return {"Disk", "ok", left + "; a trial takes about 0.5 MB a minute."};
}

HealthCheck backup_health(const std::vector<BackupFile>& backups, const std::string& now_utc) {
  if (backups.empty()) return {"Backup", "warn", "No backup yet; make one now."};
  const auto days = (day_of(now_utc) - day_of(backups.front().made_utc)).count();
  if (days > kOldBackup) {
    return {"Backup", "warn", "The newest is " + std::to_string(days) + " days old; make one now."};
  }
  if (days <= 0) return {"Backup", "ok", "The newest is of today."};
  return {"Backup", "ok",
          "The newest is " + std::to_string(days) + (days == 1 ? " day old." : " days old.")};
}

base::Result<std::vector<HealthCheck>> system_health(Site& site, database::Store& store,
                                                     const std::vector<BackupFile>& backups) {
  const auto audit = site.audit.look(store, steady_seconds());
  if (!audit) return audit.error();
  const auto curriculum = site.curricula.standard(store, site.scenes.library().catalogue());
  return std::vector<HealthCheck>{
      disk_health(site.backups.free_bytes(), site.backups.database_bytes()),
      backup_health(backups, database::utc_now()),
      {"Audit log", audit->intact ? "ok" : "bad", audit->sentence},
      curriculum ? HealthCheck{"Standard curriculum", "ok",
                               std::to_string((*curriculum)->exercises.size()) +
                                   " exercises, each passes the checker."}
                 : HealthCheck{"Standard curriculum", "bad", curriculum.error().message},
  };
}

}  // namespace app
