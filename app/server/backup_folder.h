// The backups made from the browser: files beside the database, in a folder only the server's own
// account may read. Each has its SHA-256 in a file beside it, in the form `sha256sum -c` reads.
// May be used from several threads; one backup is made at a time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "database/store.h"

namespace app {

struct BackupFile {
  std::string name;  // cathedra-YYYYMMDDThhmmssZ.db
  std::uintmax_t bytes = 0;
  std::string made_utc;  // ISO 8601
  std::string sha256;    // hex
};

// True for the names given here and for nothing else: no folder, no link out of it.
bool is_backup_name(const std::string& name);

class BackupFolder {
 public:
  explicit BackupFolder(const std::string& database_url);  // sqlite:PATH

  base::Result<std::vector<BackupFile>> list();  // newest first
  // Fails with conflict while another is being made, unavailable when the disk is too full.
  base::Result<BackupFile> make(database::Store& store, const std::string& actor);
  // The file's bytes. Fails with not_found, or conflict when it is too long to be sent at once.
  base::Result<std::string> read(const std::string& name);

  std::uintmax_t database_bytes() const;  // with the log of changes not yet merged
  std::uintmax_t free_bytes() const;      // of the disk it is on

 private:
  const std::filesystem::path database_, folder_;
  std::mutex mutex_;  // of the folder
};

}  // namespace app
