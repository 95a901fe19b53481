#include "database/store.h"

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <thread>

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "database/audit.h"
#include "database/curricula.h"
#include "tests/database/temporary_store.h"

namespace database_test {
namespace {

using base::ErrorCode;
using database::Store;

void expect_refused(const std::string& url, ErrorCode code, const std::string& words) {
  const auto store = Store::open(url);
  ASSERT_FALSE(store) << url;
  EXPECT_EQ(store.error().code, code) << store.error().message;
  EXPECT_NE(store.error().message.find(words), std::string::npos) << store.error().message;
}

TEST(Store, IsCreatedWhereThereIsNoneAndKeepsWhatItHolds) {
  TemporaryFolder folder;
  std::string id;
  {
    auto store = open_store(folder.url());
    EXPECT_EQ(store->schema_version(), 2);
    id = add_trainee(*store, "anna").id;
  }
  auto store = open_store(folder.url());
  EXPECT_EQ(store->schema_version(), 2);
  EXPECT_EQ(person_by_id(*store, id)->name, "anna");
  EXPECT_TRUE(store->check_integrity());
  EXPECT_EQ(RawFile(folder.file("store.db")).value("SELECT count(*) FROM schema_migration"), "2");
}

TEST(Store, UsesTheWriteAheadLogAndStrictTablesOnly) {
  TemporaryFolder folder;
  auto store = open_store(folder.url());
  RawFile file(folder.file("store.db"));
  EXPECT_EQ(file.value("PRAGMA journal_mode"), "wal");
  EXPECT_EQ(file.value("SELECT count(*) FROM pragma_table_list "
                       "WHERE schema = 'main' AND type = 'table' AND name NOT LIKE 'sqlite%' "
                       "AND strict = 0"),
            "0");
  // a strict table refuses text where a number belongs
  EXPECT_EQ(file.try_run("INSERT INTO audit_head (one, seq, hash) VALUES (1, 'many', '')") & 0xff,
            SQLITE_CONSTRAINT);
}

TEST(Store, OpensADatabaseOfSchema1) {
  TemporaryFolder folder;
  std::filesystem::copy(CATHEDRA_SOURCE_DIR "/tests/fixtures/database/schema-1.sqlite",
                        folder.file("old.db"));
  auto store = open_store(folder.url("old.db"));
  ASSERT_NE(store, nullptr);
  EXPECT_TRUE(store->check_integrity());
  const auto audit = verify_audit(*store);
  EXPECT_TRUE(audit) << audit.error().message;

  const auto anna = database::person_by_name(*store, "Anna");
  ASSERT_TRUE(anna);
  EXPECT_EQ(anna->display_name, "Anna Amsel");
  EXPECT_EQ(anna->level, database::Level::expert);
  EXPECT_EQ(anna->groups, std::vector<std::string>{"Autumn course"});
  const auto early = database::level_at(*store, anna->id, "2026-01-15T00:00:00Z");
  ASSERT_TRUE(early);
  EXPECT_EQ(*early, database::Level::novice);

  const auto all = database::trials(*store, {});
  ASSERT_TRUE(all);
  ASSERT_EQ(all->size(), 1u);
  const database::StoredTrial& trial = all->front();
  EXPECT_EQ(trial.head.seed, 18446744073709551615u);
  EXPECT_EQ(trial.end_reason, assessment::EndReason::completed);
  EXPECT_EQ(trial.outcome, assessment::Outcome::not_passed);
  EXPECT_EQ(trial.level, database::Level::novice);
  ASSERT_EQ(trial.metrics.size(), 2u);
  EXPECT_EQ(trial.metrics[0].id, "time_s");
  EXPECT_EQ(trial.metrics[0].value, 237.33);
  EXPECT_EQ(trial.metrics[1].value, 0.1);
  const auto chunks = trial_chunks(*store, trial.head.id, "inputs");
  ASSERT_TRUE(chunks);
  ASSERT_EQ(chunks->size(), 1u);
  EXPECT_EQ(chunks->front().bytes, bytes_of(std::string("\x00\x01\xfe\xff", 4)));
  const auto verdict = trial_verdict(*store, trial.head.id);
  ASSERT_TRUE(verdict);
  ASSERT_EQ(verdict->criteria.size(), 1u);
  EXPECT_EQ(verdict->criteria[0].bound, 180.0);
  EXPECT_EQ(trial_events(*store, trial.head.id)->size(), 1u);
  EXPECT_EQ(trial_steps(*store, trial.head.id)->size(), 1u);
  EXPECT_EQ(current_curriculum(*store, "vascular-basics")->version, "1.0.0");
  EXPECT_EQ(unfinished_trials(*store)->size(), 1u);
}

TEST(Store, RefusesADatabaseOfANewerProgram) {
  TemporaryFolder folder;
  open_store(folder.url());
  RawFile(folder.file("store.db"))
      .run("INSERT INTO schema_migration VALUES (999, '0999_later', '2030-01-01T00:00:00.000Z')");
  expect_refused(folder.url(), ErrorCode::corrupt_data, "newer");
}

TEST(Store, RefusesWhatIsNotItsOwnAndLeavesItAsItWas) {
  TemporaryFolder folder;
  std::ofstream(folder.file("letter.txt")) << std::string(5000, 'x');
  expect_refused(folder.url("letter.txt"), ErrorCode::corrupt_data, "not a Cathedra database");
  EXPECT_EQ(std::filesystem::file_size(folder.file("letter.txt")), 5000u);

  RawFile(folder.file("other.db")).run("CREATE TABLE bookmark (url TEXT)");
  expect_refused(folder.url("other.db"), ErrorCode::corrupt_data, "another program");
  EXPECT_EQ(RawFile(folder.file("other.db")).value("PRAGMA journal_mode"), "delete");
}

TEST(Store, SaysWhatIsWrongWithAnAddress) {
  TemporaryFolder folder;
  expect_refused("postgresql://server/cathedra", ErrorCode::invalid_input, "SQLite only");
  expect_refused("sqlite:", ErrorCode::invalid_input, "sqlite:PATH");
  expect_refused("cathedra.db", ErrorCode::invalid_input, "sqlite:PATH");
  expect_refused("", ErrorCode::invalid_input, "sqlite:PATH");
  expect_refused(folder.url("a\"b.db"), ErrorCode::invalid_input, "quotes");
  expect_refused(folder.url("absent/store.db"), ErrorCode::unavailable, "folder");
}

TEST(Store, TakesAPathWithBlanksQuotesAndUnicode) {
  TemporaryFolder folder;
  const std::string name = "übung 1 = 'a; b'.db";
  open_store(folder.url(name));
  EXPECT_TRUE(std::filesystem::exists(folder.file(name)));
}

// Runs in a child process that may not write, also when the tests run as root.
TEST(Store, SaysThatAFileMayOnlyBeRead) {
  TemporaryFolder folder;
  { auto store = open_store(folder.url()); }
  ASSERT_EQ(chmod(folder.file("store.db").c_str(), 0444), 0);
  ASSERT_EQ(chmod(folder.file("").c_str(), 0555), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && setuid(kNobody) != 0) _exit(3);
    const auto store = Store::open(folder.url());
    const bool said = !store && store.error().code == ErrorCode::unavailable;
    _exit(said ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  chmod(folder.file("").c_str(), 0755);
}

TEST(Store, FindsARowThatRefersToNothing) {
  TemporaryFolder folder;
  auto store = open_store(folder.url());
  RawFile(folder.file("store.db"))
      .run(
          "PRAGMA foreign_keys = OFF;"
          "INSERT INTO web_session VALUES ('hash', 'nobody', 'csrf', 'then', 'then')");
  const base::Status status = store->check_integrity();
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::corrupt_data);
  EXPECT_NE(status.error().message.find("web_session"), std::string::npos);
}

TEST(Store, IsOpenedByManyAtOnceWhileItIsBeingMade) {
  TemporaryFolder folder;
  std::vector<std::thread> threads;
  std::array<bool, 8> opened{};
  for (std::size_t i = 0; i < opened.size(); ++i) {
    threads.emplace_back([&, i] { opened[i] = Store::open(folder.url()).has_value(); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const bool each : opened) EXPECT_TRUE(each);
}

TEST(Id, IsAVersion7UuidAndUniqueAndSortsByTime) {
  // RFC 9562, 5.7
  const std::regex shape("[0-9a-f]{8}-[0-9a-f]{4}-7[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}");
  std::set<std::string> ids;
  for (int i = 0; i < 1000; ++i) ids.insert(database::new_id());
  EXPECT_EQ(ids.size(), 1000u);
  for (const std::string& id : ids) EXPECT_TRUE(std::regex_match(id, shape)) << id;
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  EXPECT_GT(database::new_id(), *ids.rbegin());
}

TEST(Utc, HasMillisecondsAndZ) {
  const std::regex shape(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z)");
  EXPECT_TRUE(std::regex_match(database::utc_now(), shape)) << database::utc_now();
}

}  // namespace
}  // namespace database_test
