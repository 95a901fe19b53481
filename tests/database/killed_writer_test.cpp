// A program that runs a trial is killed at random moments; nothing that it was told is stored may
// be lost, and what it left running is closed at the next start.
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/database/temporary_store.h"

namespace database_test {
namespace {

using database::Chunk;

constexpr int kFinished = 3;

std::vector<Chunk> second_of_trial(int seq) {
  const auto fill = static_cast<std::byte>(seq % 251);
  return {{seq, "inputs", "c", std::vector<std::byte>(static_cast<std::size_t>(50 + seq), fill)},
          {seq, "observed", "c", std::vector<std::byte>(8000, fill)}};
}

std::vector<assessment::Event> events_of_second(int seq) {
  return {{static_cast<double>(seq), "second", assessment::Severity::info, "", 0.0}};
}

// What the child does: three finished trials, then one that never ends. Each stored second is
// told to the parent only after the store has said so.
[[noreturn]] void run_until_killed(const std::string& url, const std::string& person, int pipe) {
  auto opened = database::Store::open(url);
  if (!opened) _exit(1);
  database::Store& store = **opened;
  for (int i = 0; i < kFinished; ++i) {
    const database::NewTrial trial = new_trial_of(person);
    if (!begin_trial(store, trial)) _exit(1);
    if (!finish_trial(store, trial.id, passed_in(60.0 + i), second_of_trial(0),
                      events_of_second(0))) {
      _exit(1);
    }
  }
  const database::NewTrial trial = new_trial_of(person);
  if (!begin_trial(store, trial)) _exit(1);
  for (int seq = 0;; ++seq) {
    if (!append_trace(store, trial.id, second_of_trial(seq), events_of_second(seq))) _exit(1);
    if (write(pipe, "s", 1) != 1) _exit(1);
  }
}

// Starts the child, waits for its first second, kills it `delay_us` later. How many seconds it
// was told are stored.
int kill_after(const std::string& url, const std::string& person, int delay_us) {
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    run_until_killed(url, person, ends[1]);
  }
  close(ends[1]);
  char mark = 0;
  int seconds = read(ends[0], &mark, 1) == 1 ? 1 : 0;
  std::this_thread::sleep_for(std::chrono::microseconds(delay_us));
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status)) << "the child ended by itself";
  while (read(ends[0], &mark, 1) == 1) ++seconds;
  close(ends[0]);
  return seconds;
}

void expect_finished_trials_intact(database::Store& store) {
  const auto all = trials(store, {});
  ASSERT_TRUE(all);
  ASSERT_EQ(all->size(), static_cast<std::size_t>(kFinished));
  for (int i = 0; i < kFinished; ++i) {
    const database::StoredTrial& trial = (*all)[static_cast<std::size_t>(i)];
    EXPECT_EQ(trial.outcome, assessment::Outcome::passed);
    ASSERT_EQ(trial.metrics.size(), 1u);
    EXPECT_EQ(trial.metrics[0].value, 60.0 + i);
    EXPECT_EQ(trial_chunks(store, trial.head.id, "inputs")->size(), 1u);
    EXPECT_EQ(trial_verdict(store, trial.head.id)->sentence, "Passed.");
  }
}

void expect_running_trial_recovered(database::Store& store, int seconds) {
  const auto unfinished = unfinished_trials(store);
  ASSERT_TRUE(unfinished);
  ASSERT_EQ(unfinished->size(), 1u);
  const std::string id = unfinished->front();
  EXPECT_EQ(*abort_unfinished_trials(store), 1);
  EXPECT_EQ(database::trial(store, id)->end_reason, assessment::EndReason::aborted);

  const auto inputs = trial_chunks(store, id, "inputs");
  const auto observed = trial_chunks(store, id, "observed");
  ASSERT_TRUE(inputs && observed);
  // the second that was being written may be there or not, but whole
  EXPECT_GE(static_cast<int>(inputs->size()), seconds);
  EXPECT_LE(static_cast<int>(inputs->size()), seconds + 1);
  EXPECT_EQ(observed->size(), inputs->size());
  EXPECT_EQ(trial_events(store, id)->size(), inputs->size());
  for (std::size_t i = 0; i < inputs->size(); ++i) {
    const std::vector<Chunk> written = second_of_trial(static_cast<int>(i));
    EXPECT_EQ((*inputs)[i].seq, static_cast<int>(i));
    EXPECT_EQ((*inputs)[i].bytes, written[0].bytes);
    EXPECT_EQ((*observed)[i].bytes, written[1].bytes);
  }
}

TEST(KilledWriter, LosesNothingThatWasStored) {
  std::mt19937 random(20240607);
  std::uniform_int_distribution<int> delay_us(0, 60'000);
  for (int round = 0; round < 20; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    TemporaryFolder folder;
    const std::string person = add_trainee(*open_store(folder.url()), "anna").id;
    const int seconds = kill_after(folder.url(), person, delay_us(random));
    auto store = open_store(folder.url());
    ASSERT_NE(store, nullptr);
    const base::Status status = store->check_integrity();
    EXPECT_TRUE(status) << status.error().message;
    EXPECT_GT(seconds, 0);
    expect_finished_trials_intact(*store);
    expect_running_trial_recovered(*store, seconds);
  }
}

}  // namespace
}  // namespace database_test
