// A trial steered by a person, without the server between.
#include <chrono>
#include <cstring>
#include <functional>
#include <thread>

#include <gtest/gtest.h>

#include "app/session/live_trial.h"
#include "app/session/replay.h"
#include "app/wire/frame_layout.h"
#include "database/trials.h"
#include "tests/app/session_bench.h"

namespace app::test {
namespace {

namespace at = wire::frame_header;

template <class T>
T read_at(const std::vector<std::byte>& frame, std::size_t offset) {
  T value{};
  std::memcpy(&value, frame.data() + offset, sizeof value);
  return value;
}

class LiveTrialTest : public ::testing::Test {
 protected:
  void start() {
    TrialHead head;
    head.person_id = bench.person("novice");
    head.curriculum_id = bench.curriculum().id;
    head.exercise_id = bench.exercise().id;
    id = checked(begin(*bench.store, head, *bench.scene)).trial_id;
    trial = std::make_unique<LiveTrial>(
        LiveTrialSetup{id, head.person_id, bench.scene, bench.exercise(),
                       std::make_unique<FilingKeeper>(bench.folder.url(), id)});
  }

  std::vector<std::byte> newest() {
    std::uint64_t last = 0;  // frames count from 1
    return *trial->frame(last);
  }
  // Waits for what must come; a machine under load may take its time.
  bool comes(const std::function<bool()>& wanted) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < until) {
      if (wanted()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }
  std::uint32_t step() { return read_at<std::uint32_t>(newest(), at::kStepAt); }
  float axial() { return read_at<float>(newest(), at::kHandleAxialMmAt); }

  Bench bench;
  std::string id;
  std::unique_ptr<LiveTrial> trial;
};

TEST_F(LiveTrialTest, StartsPausedAndTimeStandsStill) {
  start();
  trial->command({.feed = 50.0});
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const auto frame = newest();
  EXPECT_EQ(read_at<std::uint32_t>(frame, at::kMagicAt), wire::kFrameMagic);
  EXPECT_EQ(read_at<std::uint16_t>(frame, at::kVersionAt), wire::kFrameVersion);
  EXPECT_EQ(read_at<std::uint16_t>(frame, at::kFlagsAt), wire::kFlagPaused);
  EXPECT_EQ(read_at<std::uint32_t>(frame, at::kStepAt), 0u);
  const auto nodes = read_at<std::uint16_t>(frame, at::kNodeCountAt);
  EXPECT_GT(nodes, 2);
  EXPECT_EQ(frame.size(),
            wire::frame_size(read_at<std::uint16_t>(frame, at::kLimitCountAt), nodes));
}

TEST_F(LiveTrialTest, MovesOnCommandAndStandsStillWhenPaused) {
  start();
  trial->resume();
  trial->command({.feed = 20.0});
  ASSERT_TRUE(comes([&] { return axial() > 1.0f; }));
  trial->command({.move = 30.0});
  trial->pause();
  ASSERT_TRUE(comes(
      [&] { return (read_at<std::uint16_t>(newest(), at::kFlagsAt) & wire::kFlagPaused) != 0; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // a step under way may end
  const std::uint32_t paused_at = step();
  const float held = axial();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_EQ(step(), paused_at);
  trial->resume();
  ASSERT_TRUE(comes([&] { return step() > paused_at + 100; }));
  EXPECT_EQ(axial(), held);  // nobody holds the handle, and nothing begun before goes on
}

TEST_F(LiveTrialTest, IsFiledAsAbortedWhenDroppedAndCanBeVerified) {
  start();
  trial->resume();
  trial->command({.feed = 15.0});
  ASSERT_TRUE(comes([&] { return step() > 1200; }));
  trial.reset();
  const auto stored = checked(database::trial(*bench.store, id));
  ASSERT_TRUE(stored.end_reason);
  EXPECT_EQ(*stored.end_reason, assessment::EndReason::aborted);
  EXPECT_EQ(stored.outcome, assessment::Outcome::invalid);
  const Verification proof = checked(verify_trial(*bench.store, id, bench.scenes, {}));
  EXPECT_TRUE(proof.confirmed) << proof.sentence;
  EXPECT_GE(proof.seconds, 2);
}

TEST_F(LiveTrialTest, SaysWhenItCannotBeFiled) {
  start();
  database_test::RawFile(bench.folder.file("store.db"))
      .run("CREATE TRIGGER full BEFORE INSERT ON trace_chunk BEGIN SELECT RAISE(ABORT, 'no'); END");
  trial->resume();
  ASSERT_TRUE(comes([&] { return !trial->failure().empty(); }));
  ASSERT_TRUE(comes([&] { return trial->ended(); }));  // it does not go on as if it counted
  EXPECT_FALSE(trial->finished());
}

TEST_F(LiveTrialTest, PracticeIsJudgedAndLeavesNothing) {
  const auto contents = [&] {
    database_test::RawFile file(bench.folder.file("store.db"));
    return file.value(
        "SELECT (SELECT count(*) FROM trial) || ' ' || (SELECT count(*) FROM "
        "trace_chunk) || ' ' || (SELECT count(*) FROM audit)");
  };
  const std::string before = contents();
  trial = std::make_unique<LiveTrial>(LiveTrialSetup{
      "practice", "somebody", bench.scene, bench.exercise(), std::make_unique<PracticeKeeper>()});
  trial->resume();
  trial->command({.feed = 15.0});
  ASSERT_TRUE(comes([&] { return step() > 1200; }));
  trial->abort();
  ASSERT_TRUE(comes([&] { return trial->finished(); }));
  EXPECT_EQ(trial->result().end_reason, assessment::EndReason::aborted);
  EXPECT_EQ(trial->result().judgement.verdict.outcome, assessment::Outcome::invalid);
  EXPECT_FALSE(trial->result().judgement.metrics.empty());
  // the page goes to a debrief when a frame says that it is filed
  EXPECT_EQ(read_at<std::uint16_t>(newest(), at::kFlagsAt) & wire::kFlagFiled, 0);
  EXPECT_EQ(contents(), before);
}

}  // namespace
}  // namespace app::test
