// The state of the site, backups made and taken away, and the audit log page by page.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sodium.h>

#include "app/server/system_health.h"
#include "database/audit.h"
#include "tests/app/server_fixture.h"

namespace app::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string sha256(const std::string& bytes) {
  unsigned char digest[crypto_hash_sha256_BYTES];
  crypto_hash_sha256(digest, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  char hex[2 * crypto_hash_sha256_BYTES + 1];
  return sodium_bin2hex(hex, sizeof hex, digest, sizeof digest);
}

json named(const json& rows, const std::string& what) {
  for (const json& row : rows) {
    if (row["what"] == what) return row;
  }
  return json::object();
}

TEST(System, SaysWhatIsStoredAndThatABackupIsMissing) {
  RunningServer server;
  server.workplace.add_trial("ann");
  Client ada = server.client_of("ada");
  const json system = ada.get("/api/system").json();
  EXPECT_EQ(named(system["counts"], "People with an account")["count"], 5);
  EXPECT_EQ(named(system["counts"], "Trials")["count"], 1);
  EXPECT_EQ(named(system["health"], "Backup")["state"], "warn");
  EXPECT_EQ(named(system["health"], "Audit log")["state"], "ok");
  EXPECT_EQ(named(system["health"], "Standard curriculum")["state"], "ok");
  EXPECT_GT(named(system["storage"], "Database")["bytes"], 0);
  EXPECT_EQ(system["running_trials"], 0);
  EXPECT_TRUE(system["backups"].empty());
}

TEST(System, ABackupIsTheWholeStoreAndComesBackByteForByte) {
  RunningServer server;
  const std::string trial = server.workplace.add_trial("ann");
  Client ada = server.client_of("ada");
  const Answer made = ada.post("/api/system/backups", json::object());
  ASSERT_EQ(made.status, 201) << made.body;
  const json row = made.json();
  const Answer file = ada.get("/api/system/backups/" + row["name"].get<std::string>());
  ASSERT_EQ(file.status, 200);
  EXPECT_EQ(file.body.size(), row["bytes"]);
  EXPECT_EQ(sha256(file.body), row["sha256"]);
  EXPECT_NE(file.header("content-disposition").find("attachment"), std::string::npos);

  const fs::path copy = server.workplace.folder / "copy.db";
  std::ofstream(copy, std::ios::binary) << file.body;
  const auto store = database::Store::open("sqlite:" + copy.string());
  ASSERT_TRUE(store) << store.error().message;
  EXPECT_TRUE((*store)->check_integrity());
  EXPECT_TRUE(database::person_by_name(**store, "ann"));

  const json system = ada.get("/api/system").json();
  EXPECT_EQ(system["backups"], json::array({row}));
  EXPECT_EQ(named(system["health"], "Backup")["state"], "ok");
  const auto perms = fs::status(server.workplace.folder / "backups").permissions();
  EXPECT_EQ(perms & (fs::perms::group_all | fs::perms::others_all), fs::perms::none);
  const json log = ada.get("/api/audit").json();
  EXPECT_EQ(log["rows"][0]["action"], "backup.download");
  EXPECT_EQ(log["rows"][0]["actor"], "The ada");
  EXPECT_EQ(log["rows"][1]["action"], "backup.make");
}

TEST(System, NothingButABackupIsServedFromItsFolder) {
  RunningServer server;
  Client ada = server.client_of("ada");
  const fs::path folder = server.workplace.folder / "backups";
  fs::create_directories(folder);
  fs::create_symlink("../secret.txt", folder / "cathedra-20260101T000000Z.db");
  std::ofstream(folder / "other.db") << "x";
  for (const char* name :
       {"cathedra-20260101T000000Z.db", "other.db", "..%2Fsecret.txt", "..%2Ft.db",
        "cathedra-2026x101T000000Z.db", "cathedra-20260101T000000Z.db%2F..%2F..%2Ft.db",
        "cathedra-20260101T000000Z.db.sha256"}) {
    const Answer answer = ada.get(std::string("/api/system/backups/") + name);
    EXPECT_EQ(answer.status, 404) << name << ": " << answer.body;
  }
  EXPECT_TRUE(ada.get("/api/system").json()["backups"].empty());
}

TEST(System, TheAuditLogIsReadPageByPageWithoutGapsOrRepeats) {
  RunningServer server;
  for (int i = 0; i < 250; ++i) {
    ASSERT_TRUE(
        database::note_in_audit(server.workplace.store(), "system", "test.note", "test:x", "y"));
  }
  Client ada = server.client_of("ada");
  json page = ada.get("/api/audit").json();
  EXPECT_TRUE(page["intact"]);
  int expected = page["rows"][0]["seq"];
  EXPECT_EQ(page["rows"][0]["actor"], "the program");
  for (int pages = 1;; ++pages) {
    ASSERT_LT(pages, 10);
    for (const json& row : page["rows"]) EXPECT_EQ(row["seq"], expected--);
    if (!page["more"]) break;
    EXPECT_EQ(page["rows"].size(), 100U);
    page = ada.get("/api/audit?before=" + std::to_string(expected + 1)).json();
  }
  EXPECT_EQ(expected, 0);
  for (const char* before : {"x", "0", "-5", "1x", "99999999999999999999", "1%27"}) {
    EXPECT_EQ(ada.get(std::string("/api/audit?before=") + before).status, 400) << before;
  }
}

TEST(System, TheDiskAndOldBackupsAreSaidInTime) {
  EXPECT_STREQ(disk_health(500'000'000, 0).state, "bad");
  EXPECT_STREQ(disk_health(4'000'000'000, 0).state, "warn");
  EXPECT_STREQ(disk_health(10'000'000'000, 6'000'000'000).state, "warn");
  EXPECT_STREQ(disk_health(20'000'000'000, 6'000'000'000).state, "ok");
  const std::vector<BackupFile> one = {
      {"cathedra-20260227T235959Z.db", 1, "2026-02-27T23:59:59.000Z", ""}};
  EXPECT_STREQ(backup_health({}, "2026-03-01T00:00:00.000Z").state, "warn");
  EXPECT_EQ(backup_health(one, "2026-02-28T00:00:00.000Z").sentence, "The newest is 1 day old.");
  EXPECT_STREQ(backup_health(one, "2026-03-06T00:00:00.000Z").state, "ok");
  EXPECT_STREQ(backup_health(one, "2026-03-07T00:00:00.000Z").state, "warn");
}

}  // namespace
}  // namespace app::test
