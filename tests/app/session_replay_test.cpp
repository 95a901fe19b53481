// A stored trial is played again: confirmed when nobody touched it, and what was changed is named.
#include <cmath>

#include <gtest/gtest.h>

#include "app/devices/simulated_operator.h"
#include "app/session/recording.h"
#include "app/session/replay.h"
#include "database/trials.h"
#include "tests/app/session_bench.h"

namespace app::test {
namespace {

class Replay : public ::testing::Test {
 protected:
  Verification verify(const std::string& id) {
    return checked(verify_trial(*bench.store, id, bench.scenes, {}));
  }
  void change(const std::string& sql) {
    database_test::RawFile(bench.folder.file("store.db")).run(sql);
  }
  // The first byte of one chunk, changed in the lowest bit.
  void change_byte(const std::string& id, const std::string& kind, int seq, std::size_t at) {
    auto chunks = checked(database::trial_chunks(*bench.store, id, kind));
    std::vector<std::byte>& bytes = chunks.at(static_cast<std::size_t>(seq)).bytes;
    ASSERT_GT(bytes.size(), at);
    bytes[at] ^= std::byte{1};
    change("UPDATE trace_chunk SET bytes = x'" + hex(bytes) + "' WHERE trial_id = '" + id +
           "' AND kind = '" + kind + "' AND seq = " + std::to_string(seq));
  }
  Bench bench;
};

TEST_F(Replay, TheSameSeedGivesTheSameTrialAndAnotherSeedAnother) {
  const SimulatedResult a = bench.trial("expert", 7), b = bench.trial("expert", 7);
  const SimulatedResult c = bench.trial("expert", 8);
  EXPECT_EQ(a.end_reason, assessment::EndReason::completed);
  EXPECT_EQ(a.state_hash, b.state_hash);
  EXPECT_NE(a.state_hash, c.state_hash);
  ASSERT_EQ(a.judgement.metrics.size(), b.judgement.metrics.size());
  for (std::size_t k = 0; k < a.judgement.metrics.size(); ++k) {
    EXPECT_EQ(a.judgement.metrics[k].value, b.judgement.metrics[k].value);
  }
}

TEST_F(Replay, ConfirmsAnUntouchedTrial) {
  const SimulatedResult made = bench.trial("novice", 3);
  const Verification result = verify(made.begun.trial_id);
  EXPECT_TRUE(result.confirmed) << result.sentence;
  EXPECT_TRUE(result.same_build);
  EXPECT_EQ(result.seconds, static_cast<int>(std::ceil(made.simulated_s)));
  EXPECT_EQ(result.largest_deviation_mm, 0.0);
}

TEST_F(Replay, TheMetricsComeOutOfTheStoredTraceAgain) {
  const SimulatedResult made = bench.trial("novice", 4);
  const auto recorded = checked(load_recorded(*bench.store, made.begun.trial_id));
  const Judgement again = judge(bench.exercise(), recorded);
  ASSERT_EQ(again.metrics.size(), made.judgement.metrics.size());
  for (std::size_t k = 0; k < again.metrics.size(); ++k) {
    EXPECT_EQ(again.metrics[k].value, made.judgement.metrics[k].value) << again.metrics[k].id;
  }
}

TEST_F(Replay, NamesAChangedInputByChunkAndSecond) {
  const std::string id = bench.trial("expert", 7).begun.trial_id;
  change_byte(id, "inputs", 2, 4);  // the lowest bit of the first feed of the third second
  const Verification result = verify(id);
  EXPECT_FALSE(result.confirmed);
  EXPECT_EQ(result.chunk, "inputs 2");
  EXPECT_EQ(result.first_second, 2);
}

TEST_F(Replay, NamesAChangedObservation) {
  const std::string id = bench.trial("expert", 7).begun.trial_id;
  change_byte(id, "observed", 1, 40);
  const Verification result = verify(id);
  EXPECT_FALSE(result.confirmed);
  EXPECT_EQ(result.chunk, "observed 1");
  EXPECT_EQ(result.first_second, 1);
}

TEST_F(Replay, FindsAChangedStateHash) {
  const std::string id = bench.trial("expert", 7).begun.trial_id;
  change_byte(id, "hashes", 1, 10);
  const Verification result = verify(id);
  EXPECT_FALSE(result.confirmed);
  EXPECT_EQ(result.first_second, 1);
}

// A step number out of its second must not send the replay on for days.
TEST_F(Replay, NamesAHashOfAnotherSecond) {
  const std::string id = bench.trial("expert", 7).begun.trial_id;
  change_byte(id, "hashes", 1, 3);
  const Verification result = verify(id);
  EXPECT_FALSE(result.confirmed);
  EXPECT_EQ(result.chunk, "hashes 1");
}

TEST_F(Replay, NamesADeletedChunk) {
  const std::string id = bench.trial("expert", 7).begun.trial_id;
  change("DELETE FROM trace_chunk WHERE kind = 'inputs' AND seq = 1 AND trial_id = '" + id + "'");
  const Verification result = verify(id);
  EXPECT_FALSE(result.confirmed);
  EXPECT_EQ(result.chunk, "inputs 1");
  EXPECT_EQ(result.first_second, 1);
}

TEST_F(Replay, NamesASecondThatIsGoneAltogether) {
  const std::string id = bench.trial("expert", 7).begun.trial_id;
  change("DELETE FROM trace_chunk WHERE seq = 2 AND trial_id = '" + id + "'");
  const Verification result = verify(id);
  EXPECT_FALSE(result.confirmed);
  EXPECT_EQ(result.first_second, 2);
}

TEST_F(Replay, ConfirmsWhatACutOffTrialLeft) {
  TrialHead head;
  head.person_id = bench.person("expert");
  head.curriculum_id = bench.curriculum().id;
  head.exercise_id = bench.exercise().id;
  const BegunTrial begun = checked(begin(*bench.store, head, *bench.scene));
  SimulatedOperator hand(*find_skill("expert"), 7, 1);
  TrialRun run(bench.scene, bench.exercise());
  while (!run.ended() && run.world().observation().step < 2500) {
    run.step(hand.next(run.world().observation(), run.monitor()));
  }
  check_done(append(*bench.store, begun.trial_id, run.take_recorded()));
  // here the power goes
  EXPECT_EQ(checked(database::abort_unfinished_trials(*bench.store)), 1);
  const Verification result = verify(begun.trial_id);
  EXPECT_TRUE(result.confirmed) << result.sentence;
  EXPECT_EQ(result.seconds, 2);
  change_byte(begun.trial_id, "inputs", 1, 4);
  EXPECT_EQ(verify(begun.trial_id).chunk, "inputs 1");
}

TEST_F(Replay, WithoutARecordingTheSameHandIsJudgedTheSame) {
  const auto judged = [&](Recording recording) {
    SimulatedOperator hand(*find_skill("expert"), 7, 1);
    TrialRun run(bench.scene, bench.exercise(), recording);
    while (!run.ended()) run.step(hand.next(run.world().observation(), run.monitor()));
    EXPECT_EQ(run.take_recorded().empty(), recording == Recording::none);
    EXPECT_EQ(run.state_hash().empty(), recording == Recording::none);
    return judge(bench.exercise(), run.recorded_trial());
  };
  const Judgement recorded = judged(Recording::written), practice = judged(Recording::none);
  EXPECT_EQ(practice.verdict.sentence, recorded.verdict.sentence);
  ASSERT_EQ(practice.metrics.size(), recorded.metrics.size());
  for (std::size_t i = 0; i < recorded.metrics.size(); ++i) {
    EXPECT_EQ(practice.metrics[i].value, recorded.metrics[i].value) << recorded.metrics[i].id;
  }
}

TEST_F(Replay, SaysWhenThereIsNothingToReplay) {
  const auto unknown = verify_trial(*bench.store, "nobody", bench.scenes, {});
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, base::ErrorCode::not_found);
}

TEST_F(Replay, PracticeAndSkillMakeFaster) {
  const double expert = bench.trial("expert", 1).simulated_s;
  const double novice = bench.trial("novice", 1).simulated_s;
  EXPECT_LT(expert, bench.trial("intermediate", 1).simulated_s);
  EXPECT_LT(expert, novice);
  EXPECT_LT(bench.trial("novice", 1, 20).simulated_s, novice);
  EXPECT_FALSE(find_skill("wizard"));
}

}  // namespace
}  // namespace app::test
