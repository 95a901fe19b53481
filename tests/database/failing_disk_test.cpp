// What happens when the world does not cooperate: no space, failing writes, others writing.
#include <array>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "database/audit.h"
#include "database/connection.h"
#include "tests/database/temporary_store.h"

namespace database_test {
namespace {

using base::ErrorCode;
using database::Chunk;

// Chunks of one second that need more pages than are left.
std::vector<Chunk> large_second(int seq) {
  return {{seq, "inputs", "c", std::vector<std::byte>(20'000, std::byte{7})},
          {seq, "observed", "c", std::vector<std::byte>(200'000, std::byte{8})}};
}

void expect_consistent(database::Store& store, const std::string& trial_id, int seconds) {
  EXPECT_EQ(trial_chunks(store, trial_id, "inputs")->size(), static_cast<std::size_t>(seconds));
  EXPECT_EQ(trial_chunks(store, trial_id, "observed")->size(), static_cast<std::size_t>(seconds));
  EXPECT_EQ(trial_events(store, trial_id)->size(), static_cast<std::size_t>(seconds));
  const base::Status status = store.check_integrity();
  EXPECT_TRUE(status) << status.error().message;
  EXPECT_TRUE(verify_audit(store));
}

TEST(FullDisk, IsSaidAndLeavesNothingHalfWritten) {
  TemporaryFolder folder;
  auto store = open_store(folder.url());
  const std::string anna = add_trainee(*store, "anna").id;
  const database::NewTrial trial = new_trial_of(anna);
  ASSERT_TRUE(begin_trial(*store, trial));
  // room for 1 MB: 256 pages of 4 kB on top of the empty schema
  const int pages = std::stoi(RawFile(folder.file("store.db")).value("PRAGMA page_count"));
  run_script(store->connection(),
             ("PRAGMA max_page_count = " + std::to_string(pages + 256)).c_str());

  const std::vector<assessment::Event> events = {{0.0, "e", assessment::Severity::info, "", 0.0}};
  int seconds = 0;
  base::Status status = base::Done{};
  while (seconds < 100) {
    status = append_trace(*store, trial.id, large_second(seconds), events);
    if (!status) break;
    ++seconds;
  }
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::unavailable);
  EXPECT_NE(status.error().message.find("disk is full"), std::string::npos);
  EXPECT_GT(seconds, 0);
  expect_consistent(*store, trial.id, seconds);

  // with space again, the trial goes on where it was
  run_script(store->connection(), "PRAGMA max_page_count = 1000000");
  ASSERT_TRUE(append_trace(*store, trial.id, large_second(seconds), events));
  ASSERT_TRUE(finish_trial(*store, trial.id, passed_in(10.0), {}, {}));
  expect_consistent(*store, trial.id, seconds + 1);
}

// The file may not grow beyond a size: the operating system fails the write itself.
TEST(FailingWrite, IsSaidAndLeavesNothingHalfWritten) {
  TemporaryFolder folder;
  auto store = open_store(folder.url());
  const std::string anna = add_trainee(*store, "anna").id;
  const database::NewTrial trial = new_trial_of(anna);
  ASSERT_TRUE(begin_trial(*store, trial));

  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
  rlimit tight = before;
  tight.rlim_cur = 2'000'000;  // bytes
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &tight), 0);
  const std::vector<assessment::Event> events = {{0.0, "e", assessment::Severity::info, "", 0.0}};
  int seconds = 0;
  base::Status status = base::Done{};
  while (seconds < 100) {
    status = append_trace(*store, trial.id, large_second(seconds), events);
    if (!status) break;
    ++seconds;
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, ignored);

  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::unavailable) << status.error().message;
  expect_consistent(*store, trial.id, seconds);
  ASSERT_TRUE(append_trace(*store, trial.id, large_second(seconds), events));
  expect_consistent(*store, trial.id, seconds + 1);
}

TEST(TwoWriters, NeverSeeALockedDatabase) {
  TemporaryFolder folder;
  auto first = open_store(folder.url());
  const std::string anna = add_trainee(*first, "anna").id;
  constexpr int kTrials = 10;
  constexpr int kSeconds = 10;
  const auto work = [&](std::string& failure) {
    auto store = open_store(folder.url());
    for (int i = 0; i < kTrials && failure.empty(); ++i) {
      const database::NewTrial trial = new_trial_of(anna);
      if (const auto begun = begin_trial(*store, trial); !begun) failure = begun.error().message;
      for (int second = 0; second < kSeconds && failure.empty(); ++second) {
        const std::vector<Chunk> chunks = {{second, "inputs", "c", bytes_of("x")}};
        const base::Status status = append_trace(*store, trial.id, chunks, {});
        if (!status) failure = status.error().message;
      }
      const base::Status done = finish_trial(*store, trial.id, passed_in(1.0), {}, {});
      if (!done) failure = done.error().message;
      const auto list = trials(*store, {});
      if (!list) failure = list.error().message;
    }
  };
  std::array<std::string, 2> failures;
  std::thread one(work, std::ref(failures[0]));
  std::thread two(work, std::ref(failures[1]));
  one.join();
  two.join();
  EXPECT_EQ(failures[0], "");
  EXPECT_EQ(failures[1], "");
  const auto all = trials(*first, {});
  ASSERT_EQ(all->size(), 2u * kTrials);
  for (std::size_t i = 0; i < all->size(); ++i) {
    EXPECT_EQ((*all)[i].ordinal, static_cast<int>(i) + 1);
  }
  EXPECT_TRUE(first->check_integrity());
}

}  // namespace
}  // namespace database_test
