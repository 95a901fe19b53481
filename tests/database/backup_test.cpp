#include "database/backup.h"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "database/audit.h"
#include "tests/database/temporary_store.h"

namespace database_test {
namespace {

using base::ErrorCode;

// Every row of every table, as text.
std::vector<std::string> content(const std::string& path) {
  RawFile file(path);
  std::vector<std::string> all;
  for (const std::string& table :
       file.rows("SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name")) {
    all.push_back(table);
    std::string columns;
    for (const std::string& column :
         file.rows("SELECT name FROM pragma_table_info('" + table + "')")) {
      columns += (columns.empty() ? "" : ", ") + ("quote(" + column + ")");
    }
    for (const std::string& row :
         file.rows("SELECT " + columns + " FROM " + table + " ORDER BY 1, 2"))
      all.push_back(row);
  }
  return all;
}

TEST(Backup, HoldsEveryRow) {
  TemporaryFolder folder;
  auto store = open_store(folder.url());
  const database::NewTrial trial = new_trial_of(add_trainee(*store, "anna").id);
  ASSERT_TRUE(begin_trial(*store, trial));
  const std::vector<database::Chunk> chunks = {{0, "inputs", "c", bytes_of("abc")}};
  ASSERT_TRUE(finish_trial(*store, trial.id, passed_in(5.0), chunks, {}));
  const base::Status status = backup(*store, folder.file("copy.db"));
  ASSERT_TRUE(status) << status.error().message;
  EXPECT_EQ(content(folder.file("copy.db")), content(folder.file("store.db")));
  auto copy = open_store(folder.url("copy.db"));
  EXPECT_EQ(*audit_head(*copy), *audit_head(*store));
  EXPECT_FALSE(std::filesystem::exists(folder.file("copy.db.part")));
}

TEST(Backup, IsOfOneMomentWhileOthersWrite) {
  TemporaryFolder folder;
  auto store = open_store(folder.url());
  const std::string anna = add_trainee(*store, "anna").id;
  std::atomic<bool> stop = false;
  std::thread writer([&] {
    auto own = open_store(folder.url());
    while (!stop) {
      const database::NewTrial trial = new_trial_of(anna);
      EXPECT_TRUE(begin_trial(*own, trial));
      const std::vector<database::Chunk> chunks = {{0, "inputs", "c", bytes_of("abc")}};
      EXPECT_TRUE(finish_trial(*own, trial.id, passed_in(1.0), chunks, {}));
    }
  });
  for (int i = 0; i < 5; ++i) {
    const std::string name = "copy" + std::to_string(i) + ".db";
    const base::Status status = backup(*store, folder.file(name));
    EXPECT_TRUE(status) << status.error().message;
    auto copy = open_store(folder.url(name));
    EXPECT_TRUE(copy->check_integrity());
    const auto copied = trials(*copy, {});
    for (const database::StoredTrial& trial : *copied) {
      EXPECT_EQ(trial.metrics.size(), 1u);
      EXPECT_EQ(trial_chunks(*copy, trial.head.id, "inputs")->size(), 1u);
    }
  }
  stop = true;
  writer.join();
}

TEST(Backup, NeverOverwritesAndSaysWhereItCannotWrite) {
  TemporaryFolder folder;
  auto store = open_store(folder.url());
  EXPECT_EQ(backup(*store, folder.file("store.db")).error().code, ErrorCode::conflict);
  EXPECT_EQ(backup(*store, folder.file("absent/copy.db")).error().code, ErrorCode::unavailable);
  EXPECT_EQ(backup(*store, "").error().code, ErrorCode::invalid_input);
}

}  // namespace
}  // namespace database_test
