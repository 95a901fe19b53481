#include "app/server/backup_folder.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <optional>
#include <system_error>

#include <sodium.h>

#include "database/audit.h"
#include "database/backup.h"

namespace app {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::ErrorCode;

constexpr std::uintmax_t kLongestDownload = std::uintmax_t{512} << 20;  // bytes, held in memory
constexpr std::uintmax_t kSpare = std::uintmax_t{256}
                                  << 20;  // bytes that trials may need meanwhile
constexpr std::string_view kPattern = "cathedra-########T######Z.db";  // #: a digit
constexpr std::size_t kHashDigits = 2 * crypto_hash_sha256_BYTES;

fs::path beside(const std::string& url) {
  constexpr std::string_view kScheme = "sqlite:";
  return fs::absolute(url.starts_with(kScheme) ? url.substr(kScheme.size()) : url);
}

std::uintmax_t size_or_zero(const fs::path& path) {
  std::error_code failure;
  const std::uintmax_t bytes = fs::file_size(path, failure);
  return failure ? 0 : bytes;
}

bool is_plain_file(const fs::path& path) {
  std::error_code failure;
  return fs::is_regular_file(fs::symlink_status(path, failure));
}

// 2026-11-23T10:11:12.000Z -> cathedra-20261123T101112Z.db
std::string name_for(const std::string& utc) {
  std::string digits;
  for (const char c : utc.substr(0, 19)) {
    if (c != '-' && c != ':') digits += c;
  }
  return "cathedra-" + digits + "Z.db";
}

std::string made_utc(const std::string& name) {
  const std::string t = name.substr(9, 15);
  return t.substr(0, 4) + "-" + t.substr(4, 2) + "-" + t.substr(6, 5) + ":" + t.substr(11, 2) +
         ":" + t.substr(13, 2) + ".000Z";
}

base::Result<std::string> sha256_of(const fs::path& path) {
  crypto_hash_sha256_state state;
  crypto_hash_sha256_init(&state);
  std::ifstream file(path, std::ios::binary);
  std::vector<char> part(std::size_t{1} << 16);
  while (file) {
    file.read(part.data(), static_cast<std::streamsize>(part.size()));
    crypto_hash_sha256_update(&state, reinterpret_cast<const unsigned char*>(part.data()),
                              static_cast<unsigned long long>(file.gcount()));
  }
  if (!file.eof()) {
    return Error{ErrorCode::unavailable, "The backup " + path.filename().string() +
                                             " cannot be read; look at the server's disk."};
  }
  std::array<unsigned char, crypto_hash_sha256_BYTES> digest{};
  crypto_hash_sha256_final(&state, digest.data());
  std::array<char, kHashDigits + 1> hex{};
  sodium_bin2hex(hex.data(), hex.size(), digest.data(), digest.size());
  return std::string(hex.data());
}

// Reads the hash beside the file, or works it out and puts it there: for a file copied here by
// hand. A hash that cannot be kept is worked out again next time.
base::Result<std::string> kept_sha256(const fs::path& path) {
  const fs::path kept = path.string() + ".sha256";
  std::string hex;
  if (std::ifstream(kept) >> hex && hex.size() == kHashDigits) return hex;
  auto worked_out = sha256_of(path);
  if (worked_out) std::ofstream(kept) << *worked_out << "  " << path.filename().string() << '\n';
  return worked_out;
}

base::Result<BackupFile> describe(const fs::path& path) {
  const std::string name = path.filename().string();
  const auto sha256 = kept_sha256(path);
  if (!sha256) return sha256.error();
  return BackupFile{name, size_or_zero(path), made_utc(name), *sha256};
}

void discard(const fs::path& path) {
  std::error_code ignored;
  fs::remove(path, ignored);
  fs::remove(path.string() + ".sha256", ignored);
}

base::Status prepare(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (!failure) fs::permissions(folder, fs::perms::owner_all, failure);  // it holds every password
  if (!failure) return base::Done{};
  return Error{ErrorCode::unavailable, "The folder for backups cannot be made (" +
                                           failure.message() + "); look at the server's disk."};
}

}  // namespace

bool is_backup_name(const std::string& name) {
  return std::equal(
      name.begin(), name.end(), kPattern.begin(), kPattern.end(),
      [](char c, char expected) { return expected == '#' ? c >= '0' && c <= '9' : c == expected; });
}

BackupFolder::BackupFolder(const std::string& database_url)
    : database_(beside(database_url)), folder_(database_.parent_path() / "backups") {}

base::Result<std::vector<BackupFile>> BackupFolder::list() {
  std::vector<BackupFile> files;
  std::error_code failure;
  for (fs::directory_iterator entry(folder_, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const fs::path path = entry->path();
    if (!is_backup_name(path.filename().string()) || !is_plain_file(path)) continue;
    auto file = describe(path);
    if (!file) return file.error();
    files.push_back(*std::move(file));
  }
  if (failure && failure != std::errc::no_such_file_or_directory) {
    return Error{ErrorCode::unavailable,
                 "The folder of backups cannot be read (" + failure.message() + ")."};
  }
  std::sort(files.begin(), files.end(),
            [](const BackupFile& a, const BackupFile& b) { return a.name > b.name; });
  return files;
}

base::Result<BackupFile> BackupFolder::make(database::Store& store, const std::string& actor) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) {
    return Error{ErrorCode::conflict, "A backup is being made already; wait until it is done."};
  }
  if (free_bytes() < database_bytes() + kSpare) {
    return Error{ErrorCode::unavailable,
                 "The server's disk has no room for a backup; take old ones away first."};
  }
  if (const auto ready = prepare(folder_); !ready) return ready.error();
  const fs::path path = folder_ / name_for(database::utc_now());
  if (fs::exists(path)) {
    return Error{ErrorCode::conflict, "A backup was made this very second; it is in the list."};
  }
  if (const auto copied = database::backup(store, path.string()); !copied) return copied.error();
  auto file = describe(path);
  const base::Status noted = file ? database::note_in_audit(store, actor, "backup.make",
                                                            "backup:" + file->name, file->sha256)
                                  : base::Status(file.error());
  if (noted) return file;
  discard(path);
  return noted.error();
}

base::Result<std::string> BackupFolder::read(const std::string& name) {
  const fs::path path = folder_ / name;
  if (!is_backup_name(name) || !is_plain_file(path)) {
    return Error{ErrorCode::not_found, "There is no such backup; look at the list again."};
  }
  const std::uintmax_t bytes = size_or_zero(path);
  if (bytes > kLongestDownload) {
    return Error{ErrorCode::conflict, "This backup is too long for the browser (" +
                                          std::to_string(bytes >> 20) +
                                          " MiB); copy it from the server's folder backups."};
  }
  std::string content(bytes, '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(content.data(), static_cast<std::streamsize>(bytes))) {
    return Error{ErrorCode::unavailable, "The backup cannot be read; look at the server's disk."};
  }
  return content;
}

std::uintmax_t BackupFolder::database_bytes() const {
  return size_or_zero(database_) + size_or_zero(database_.string() + "-wal");
}

std::uintmax_t BackupFolder::free_bytes() const {
  std::error_code failure;
  const fs::space_info space = fs::space(database_.parent_path(), failure);
  return failure ? 0 : space.available;
}

}  // namespace app
