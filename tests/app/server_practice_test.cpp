// Practice over the wire: judged like a trial, seen by nobody else, kept nowhere.
#include <chrono>
#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include "app/server/practice_results.h"
#include "database/audit.h"
#include "database/trials.h"
#include "tests/app/live_channel.h"
#include "tests/app/server_fixture.h"

namespace app::test {
namespace {

using nlohmann::json;

const json kLinear = {{"exercise_id", "linear"}, {"device", "keyboard"}};

class Practice : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    running_ = std::make_unique<RunningServer>(
        [](ServerOptions& options) { options.abandon_practice_after_s = 3.0; });
  }
  static void TearDownTestSuite() { running_.reset(); }
  void TearDown() override { wait_until_over(client_); }

  static std::uint16_t port() { return running_->server.port(); }
  // What the database holds that a trial would have changed.
  static std::string contents() {
    database::TrialFilter filter;
    filter.finished_only = false;
    const auto trials = database::trials(running_->workplace.store(), filter);
    const auto audit = database::audit_head(running_->workplace.store());
    EXPECT_TRUE(trials && audit);
    return std::to_string(trials->size()) + " trials, audit " + *audit;
  }
  void begin() {
    const Answer answer = client_.post("/api/practice", kLinear);
    ASSERT_EQ(answer.status, 201) << answer.body;
    begun_ = answer.json();
    id_ = begun_["trial_id"];
  }
  // Nothing running any more: practice that stands still ends by itself.
  static bool wait_until_over(Client& client) {
    for (int i = 0; i < 200; ++i) {
      if (client.get("/api/live/mine").json()["trial"].is_null()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
  }
  // Runs for a moment and is ended by its person; the notice that came.
  json practise() {
    Channel channel;
    EXPECT_EQ(channel.open(port(), id_, client_.cookie), 101);
    channel.send({{"type", "resume"}});
    EXPECT_FALSE(channel.frame_where([](const std::string& f) { return !is_paused(f); }).empty());
    channel.send({{"type", "end"}});
    for (auto message = channel.next(); message; message = channel.next()) {
      if (!channel.got_frame()) return json::parse(*message);
      EXPECT_EQ(read_at<std::uint16_t>(*message, kFlagsAt) & kFiled, 0);
    }
    return nullptr;
  }

  static std::unique_ptr<RunningServer> running_;
  Client client_ = running_->client_of("ann");
  json begun_;
  std::string id_;
};
std::unique_ptr<RunningServer> Practice::running_;

TEST_F(Practice, IsJudgedAtItsEndAndRecordsNothing) {
  const std::string before = contents();
  begin();
  EXPECT_EQ(begun_["practice"], true);
  EXPECT_EQ(begun_["ordinal"], 0);
  EXPECT_EQ(begun_["briefing"]["exercise_id"], "linear");
  EXPECT_EQ(client_.get("/api/live/mine").json()["trial"]["practice"], true);
  EXPECT_EQ(client_.get("/api/practice/" + id_ + "/result").status, 409);
  const json notice = practise();
  EXPECT_EQ(notice["type"], "practice_ended");
  EXPECT_EQ(notice["trial_id"], id_);

  const Answer result = client_.get("/api/practice/" + id_ + "/result");
  ASSERT_EQ(result.status, 200) << result.body;
  EXPECT_EQ(result.json()["exercise_id"], "linear");
  EXPECT_EQ(result.json()["end_reason"], "aborted");
  EXPECT_FALSE(result.json()["verdict_sentence"].get<std::string>().empty());
  EXPECT_FALSE(result.json()["criteria"].empty());
  EXPECT_FALSE(result.json()["metrics"].empty());
  EXPECT_EQ(client_.get("/api/live/mine").json()["trial"], nullptr);
  EXPECT_EQ(client_.get("/api/trials/" + id_).status, 404);
  EXPECT_EQ(contents(), before);
}

TEST_F(Practice, IsSeenByNobodyElseNotEvenByTheInstructor) {
  begin();
  const auto watch = [&](const char* name) {
    Channel channel;
    EXPECT_NE(channel.open(port(), id_, running_->client_of(name).cookie), 101);
    return running_->client_of(name).get("/api/live/" + id_).status;
  };
  EXPECT_EQ(watch("ina"), 403);
  EXPECT_EQ(watch("ada"), 403);
  EXPECT_EQ(watch("ben"), 403);
  EXPECT_TRUE(running_->client_of("ina").get("/api/live").json()["trials"].empty());
  practise();
  for (const char* name : {"ina", "ada", "ben"}) {
    EXPECT_EQ(running_->client_of(name).get("/api/practice/" + id_ + "/result").status, 403);
  }
  EXPECT_EQ(client_.get("/api/practice/none/result").status, 404);
}

TEST_F(Practice, AndTrialsDoNotEndEachOtherSilently) {
  begin();
  const Answer trial = client_.post("/api/trials", kLinear);
  EXPECT_EQ(trial.status, 409);
  EXPECT_EQ(trial.json()["error"], "You are practising; go back to it, or end the practice first.");
  EXPECT_EQ(client_.post("/api/practice", kLinear).status, 409);
  EXPECT_EQ(client_.get("/api/live/mine").json()["trial"]["trial_id"], id_);  // it still runs
  practise();

  const Answer real = client_.post("/api/trials", kLinear);
  ASSERT_EQ(real.status, 201) << real.body;
  EXPECT_EQ(real.json()["practice"], false);
  EXPECT_EQ(client_.post("/api/practice", kLinear).status, 409);
  Channel channel;
  ASSERT_EQ(channel.open(port(), real.json()["trial_id"], client_.cookie), 101);
  channel.send({{"type", "end"}});
  EXPECT_EQ(channel.notice()["type"], "filed");
}

TEST_F(Practice, EndsByItselfWhenItStandsStillAlsoInAnOpenTab) {
  begin();
  Channel channel;
  ASSERT_EQ(channel.open(port(), id_, client_.cookie), 101);
  EXPECT_EQ(channel.notice()["type"], "practice_ended");
  EXPECT_EQ(client_.get("/api/practice/" + id_ + "/result").status, 200);
}

TEST_F(Practice, TakesAnExerciseThatIsUsedUpForToday) {
  // the plan allows ten trials a day
  client_ = running_->client_of("ben");
  for (int i = 0; i < 10; ++i) running_->workplace.add_trial("ben");
  ASSERT_EQ(client_.post("/api/trials", kLinear).status, 403);
  begin();
  practise();
}

TEST_F(Practice, RefusesWhatTheCurriculumDoesNotHave) {
  EXPECT_EQ(client_.post("/api/practice", {{"exercise_id", "none"}, {"device", "keyboard"}}).status,
            404);
  EXPECT_EQ(client_.post("/api/practice", {{"exercise_id", "linear"}, {"device", "<b>"}}).status,
            400);
}

TEST(PracticeResults, AreForgottenAfterTenMinutes) {
  PracticeResults results;
  results.keep("p", {"ann", "linear", {}}, 100.0);
  EXPECT_TRUE(results.find("p", 100.0 + PracticeResults::kKept));
  EXPECT_FALSE(results.find("p", 101.0 + PracticeResults::kKept));
  EXPECT_FALSE(results.find("q", 100.0));
}

TEST(PracticeResults, KeepAThousandAndLetTheOldestGo) {
  PracticeResults results;
  for (std::size_t i = 0; i <= PracticeResults::kMostKept; ++i) {
    results.keep(std::to_string(100'000 + i), {"ann", "linear", {}}, 1.0);
  }
  EXPECT_FALSE(results.find("100000", 1.0));
  EXPECT_TRUE(results.find("100001", 1.0));
}

}  // namespace
}  // namespace app::test
