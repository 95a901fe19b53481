// The live channel, with a real trial behind it.
#include <chrono>
#include <memory>
#include <set>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "database/trials.h"
#include "tests/app/live_channel.h"
#include "tests/app/server_fixture.h"

namespace app::test {
namespace {

// One server for all: its vessel takes a while to build. Two trainees share the tests, because the
// curriculum allows ten trials a day.
class Live : public testing::Test {
 protected:
  static void SetUpTestSuite() { running_ = std::make_unique<RunningServer>(); }
  static void TearDownTestSuite() { running_.reset(); }

  void TearDown() override {
    if (trial_.empty()) return;
    Channel channel;
    if (channel.open(port(), trial_, client_.cookie) != 101) return;
    for (int tries = 0; tries < 50; ++tries) {  // the test's own channel may still hold the wheel
      channel.send({{"type", "end"}});
      const nlohmann::json notice = channel.notice();
      if (!notice.is_object() || notice["type"] == "filed") return;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  static std::uint16_t port() { return running_->server.port(); }

  void begin(const std::string& name = "ann") {
    client_ = running_->client_of(name);
    const Answer answer =
        client_.post("/api/trials", {{"exercise_id", "linear"}, {"device", "keyboard"}});
    ASSERT_EQ(answer.status, 201) << answer.body;
    trial_ = answer.json()["trial_id"];
  }

  static std::unique_ptr<RunningServer> running_;
  Client client_{0};
  std::string trial_;
};
std::unique_ptr<RunningServer> Live::running_;

// The status of an attempt to open the channel, as it stands on the line.
int handshake(Client client, const std::string& trial, const std::string& origin) {
  Headers headers{{"Connection", "Upgrade"},
                  {"Upgrade", "websocket"},
                  {"Sec-WebSocket-Version", "13"},
                  {"Sec-WebSocket-Key", "AAAAAAAAAAAAAAAAAAAAAA=="}};
  if (!origin.empty()) headers["Origin"] = origin;
  return client.send("GET", "/api/live/" + trial, "", headers).status;
}

TEST_F(Live, WithoutSessionOrFromAnotherOriginNobodyGetsIn) {
  begin();
  const std::string own = "http://127.0.0.1:" + std::to_string(port());
  Client forged = running_->client();
  EXPECT_EQ(handshake(forged, trial_, own), 401);
  forged.cookie = "cathedra=forged";
  EXPECT_EQ(handshake(forged, trial_, own), 401);
  EXPECT_EQ(handshake(client_, trial_, "http://evil.example"), 403);
  EXPECT_EQ(handshake(client_, trial_, "null"), 403);
  EXPECT_EQ(handshake(client_, trial_, ""), 403);
  EXPECT_EQ(handshake(client_, "none", own), 404);
  EXPECT_EQ(handshake(running_->client_of("ben"), trial_, own), 403);
  EXPECT_EQ(handshake(running_->client_of("rex"), trial_, own), 403);
  EXPECT_EQ(Channel().open(port(), trial_, client_.cookie), 101);
}

TEST_F(Live, AnEndedTrialHasNoChannel) {
  const std::string trial = running_->workplace.add_trial("ben");
  const std::string own = "http://127.0.0.1:" + std::to_string(port());
  EXPECT_EQ(handshake(running_->client_of("ben"), trial, own), 404);
}

TEST_F(Live, APlainRequestIsToldToUpgrade) {
  begin("ben");
  EXPECT_EQ(client_.get("/api/live/" + trial_).status, 426);
}

TEST_F(Live, OnePersonRunsOneTrialAndFindsItAgain) {
  begin();
  const Answer second =
      client_.post("/api/trials", {{"exercise_id", "linear"}, {"device", "keyboard"}});
  EXPECT_EQ(second.status, 409);
  const Answer mine = client_.get("/api/live/mine");
  ASSERT_EQ(mine.status, 200);
  EXPECT_EQ(mine.json()["trial"]["trial_id"], trial_);
  EXPECT_EQ(mine.json()["trial"]["briefing"]["exercise_id"], "linear");
  EXPECT_EQ(running_->client_of("ben").get("/api/live/mine").json()["trial"], nullptr);
}

TEST_F(Live, UnknownExercisesAndDevicesAreRefused) {
  Client client = running_->client_of("ann");
  EXPECT_EQ(client.post("/api/trials", {{"exercise_id", "none"}, {"device", "keyboard"}}).status,
            404);
  EXPECT_EQ(client.post("/api/trials", {{"exercise_id", "linear"}, {"device", "<b>"}}).status, 400);
  EXPECT_EQ(client.post("/api/trials", {{"exercise_id", "linear"}, {"device", ""}}).status, 400);
}

TEST_F(Live, TheTrialStartsPausedAndTheHandleMovesTheInstrument) {
  begin();
  Channel channel;
  ASSERT_EQ(channel.open(port(), trial_, client_.cookie), 101);
  const std::string first = channel.frame();
  ASSERT_GE(first.size(), 104U);
  EXPECT_EQ(read_at<std::uint32_t>(first, 0), kMagic);
  EXPECT_TRUE(is_paused(first));
  EXPECT_EQ(read_at<std::uint32_t>(first, kStepAt), 0U);

  channel.send({{"type", "resume"}});
  channel.send({{"type", "handle"}, {"feed_mm_s", 20.0}, {"turn_deg_s", 0.0}});
  const std::string moved = channel.frame_where(
      [](const std::string& frame) { return read_at<float>(frame, kAxialAt) > 1.0F; });
  ASSERT_FALSE(moved.empty());
  // the hand cannot be faster than it was told: 20 mm/s is 0.02 mm a step
  EXPECT_LE(read_at<float>(moved, kAxialAt),
            0.02F * static_cast<float>(read_at<std::uint32_t>(moved, kStepAt)) + 0.01F);
}

TEST_F(Live, PingsAreAnswered) {
  begin("ben");
  Channel channel;
  ASSERT_EQ(channel.open(port(), trial_, client_.cookie), 101);
  channel.send({{"type", "ping"}, {"sent_ms", 12345.5}});
  const nlohmann::json pong = channel.notice();
  EXPECT_EQ(pong["type"], "pong");
  EXPECT_EQ(pong["sent_ms"], 12345.5);
}

TEST_F(Live, MalformedMessagesAreNamedAndTheTenthClosesTheDoor) {
  begin("ben");
  Channel channel;
  ASSERT_EQ(channel.open(port(), trial_, client_.cookie), 101);
  const std::string malformed[] = {"{", "[]", "{\"type\":\"fly\"}", "{\"type\":\"handle\"}",
                                   "{\"type\":\"handle\",\"feed_mm_s\":1e9,\"turn_deg_s\":0}"};
  for (int i = 0; i < 10; ++i) {
    channel.send(malformed[i % 5]);
    const nlohmann::json notice = channel.notice();
    ASSERT_EQ(notice.value("type", ""), "error") << i;
    EXPECT_FALSE(notice.value("message", "").empty());
  }
  EXPECT_TRUE(channel.closes());
  EXPECT_EQ(running_->client().get("/api/health").status, 200);
}

TEST_F(Live, AMessageOver4KiBClosesTheDoor) {
  begin("ben");
  Channel channel;
  ASSERT_EQ(channel.open(port(), trial_, client_.cookie), 101);
  channel.send("{\"type\":\"pause\"" + std::string(5000, ' ') + "}");
  EXPECT_TRUE(channel.closes());
}

TEST_F(Live, ASecondTabWatchesButDoesNotSteer) {
  begin("ben");
  Channel first, second;
  ASSERT_EQ(first.open(port(), trial_, client_.cookie), 101);
  ASSERT_FALSE(first.frame().empty());
  ASSERT_EQ(second.open(port(), trial_, client_.cookie), 101);
  EXPECT_EQ(second.notice()["type"], "second_tab");
  second.send({{"type", "resume"}});
  EXPECT_EQ(second.notice()["type"], "second_tab");
  EXPECT_TRUE(is_paused(second.frame()));

  // when the first is gone, the second may go on
  first.close();
  std::string running;
  for (int tries = 0; tries < 50 && (running.empty() || is_paused(running)); ++tries) {
    second.send({{"type", "resume"}});
    running = second.frame();
  }
  EXPECT_FALSE(is_paused(running));
}

TEST_F(Live, ALostConnectionPausesAndReconnectingResumes) {
  begin();
  auto channel = std::make_unique<Channel>();
  ASSERT_EQ(channel->open(port(), trial_, client_.cookie), 101);
  channel->send({{"type", "resume"}});
  ASSERT_FALSE(channel->frame_where([](const std::string& f) { return !is_paused(f); }).empty());
  channel->drop();

  Channel again;
  ASSERT_EQ(again.open(port(), trial_, client_.cookie), 101);
  const std::string paused = again.frame_where(is_paused);
  ASSERT_FALSE(paused.empty());
  const auto step = read_at<std::uint32_t>(paused, kStepAt);
  std::string later;
  for (int tries = 0; tries < 100; ++tries) {
    again.send({{"type", "resume"}});
    later = again.frame();
    if (later.empty() || read_at<std::uint32_t>(later, kStepAt) > step) break;
  }
  ASSERT_FALSE(later.empty());
  EXPECT_GT(read_at<std::uint32_t>(later, kStepAt), step);
}

TEST_F(Live, EndingFilesTheTrialAsAborted) {
  begin();
  Channel channel;
  ASSERT_EQ(channel.open(port(), trial_, client_.cookie), 101);
  EXPECT_EQ(client_.get("/api/trials/" + trial_).status, 409);  // no debrief while it runs
  channel.send({{"type", "resume"}});
  ASSERT_FALSE(channel.frame_where([](const std::string& f) { return !is_paused(f); }).empty());
  channel.send({{"type", "end"}});
  const nlohmann::json filed = channel.notice();
  EXPECT_EQ(filed["type"], "filed");
  EXPECT_EQ(filed["trial_id"], trial_);
  const Answer debrief = client_.get("/api/trials/" + trial_);
  ASSERT_EQ(debrief.status, 200) << debrief.body;
  EXPECT_EQ(debrief.json()["trial"]["end_reason"], "aborted");
  EXPECT_EQ(debrief.json()["trial"]["source"], "live");
  EXPECT_EQ(debrief.json()["trial"]["device"], "keyboard");
  EXPECT_EQ(client_.get("/api/live/mine").json()["trial"], nullptr);
}

TEST_F(Live, TheInstructorWatchesButDoesNotSteer) {
  begin();
  Channel watcher;
  ASSERT_EQ(watcher.open(port(), trial_, running_->client_of("ina").cookie), 101);
  EXPECT_FALSE(watcher.frame().empty());
  watcher.send({{"type", "end"}});
  EXPECT_EQ(watcher.notice()["type"], "error");
  // the wheel is still free for the person whose trial it is
  Channel own;
  ASSERT_EQ(own.open(port(), trial_, client_.cookie), 101);
  own.send({{"type", "resume"}});
  EXPECT_FALSE(own.frame_where([](const std::string& f) { return !is_paused(f); }).empty());
}

TEST_F(Live, AWatcherWhoTriesToSteerAndLeavesDisturbsNothing) {
  begin();
  Channel own;
  ASSERT_EQ(own.open(port(), trial_, client_.cookie), 101);
  own.send({{"type", "resume"}});
  ASSERT_FALSE(own.frame_where([](const std::string& f) { return !is_paused(f); }).empty());
  {
    Channel watcher;
    ASSERT_EQ(watcher.open(port(), trial_, running_->client_of("ina").cookie), 101);
    watcher.send({{"type", "handle"}, {"feed_mm_s", 50.0}, {"turn_deg_s", 0.0}});
    for (const char* control : {"pause", "resume", "end"}) {
      watcher.send({{"type", control}});
      EXPECT_EQ(watcher.notice()["type"], "error") << control;
    }
    watcher.drop();
  }
  const auto step = read_at<std::uint32_t>(own.frame(), kStepAt);
  const std::string later = own.frame_where([&](const std::string& frame) {
    return is_paused(frame) || read_at<std::uint32_t>(frame, kStepAt) > step + 500;
  });
  ASSERT_FALSE(later.empty());
  EXPECT_FALSE(is_paused(later));
  EXPECT_EQ(read_at<float>(later, kAxialAt), 0.0F);  // the watcher's hand moved nothing
}

TEST_F(Live, TheListOfRunningTrialsShowsThoseOneMayWatch) {
  begin();
  Client ben = running_->client_of("ben");
  const Answer second =
      ben.post("/api/trials", {{"exercise_id", "rotational"}, {"device", "gamepad"}});
  ASSERT_EQ(second.status, 201) << second.body;
  const std::string of_ben = second.json()["trial_id"];
  const auto ids = [](Client client) {
    std::set<std::string> found;
    const nlohmann::json body = client.get("/api/live").json();
    for (const auto& trial : body["trials"]) found.insert(trial["trial_id"]);
    return found;
  };
  EXPECT_EQ(ids(running_->client_of("ina")), (std::set<std::string>{trial_}));
  EXPECT_EQ(ids(running_->client_of("ada")), (std::set<std::string>{trial_, of_ben}));
  EXPECT_EQ(ids(client_), (std::set<std::string>{trial_}));
  EXPECT_EQ(ids(ben), (std::set<std::string>{of_ben}));

  const nlohmann::json body = ben.get("/api/live").json();
  const nlohmann::json& row = body["trials"][0];
  EXPECT_EQ(row["person_name"], "The ben");
  EXPECT_EQ(row["exercise_id"], "rotational");
  EXPECT_EQ(row["device"], "gamepad");
  EXPECT_EQ(row["paused"], true);
  EXPECT_EQ(row["briefing"]["exercise_id"], "rotational");
  Channel channel;
  ASSERT_EQ(channel.open(port(), of_ben, ben.cookie), 101);
  channel.send({{"type", "end"}});
  EXPECT_EQ(channel.notice()["type"], "filed");
  EXPECT_TRUE(ids(ben).empty());
}

TEST(LiveServer, StoppingTheServerFilesTheRunningTrial) {
  RunningServer running;
  Client client = running.client_of("ann");
  const Answer begun =
      client.post("/api/trials", {{"exercise_id", "linear"}, {"device", "keyboard"}});
  ASSERT_EQ(begun.status, 201) << begun.body;
  running.server.stop();
  const auto trial = database::trial(running.workplace.store(), begun.json()["trial_id"]);
  ASSERT_TRUE(trial);
  EXPECT_EQ(trial->end_reason, assessment::EndReason::aborted);
}

TEST(LiveServer, ATrialNobodySteersIsFiledAfterAWhile) {
  RunningServer running([](ServerOptions& options) { options.abandon_live_after_s = 0.2; });
  Client client = running.client_of("ann");
  const Answer begun =
      client.post("/api/trials", {{"exercise_id", "linear"}, {"device", "keyboard"}});
  ASSERT_EQ(begun.status, 201) << begun.body;
  for (int i = 0; i < 100; ++i) {
    if (client.get("/api/live/mine").json()["trial"].is_null()) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  const auto trial = database::trial(running.workplace.store(), begun.json()["trial_id"]);
  ASSERT_TRUE(trial);
  EXPECT_EQ(trial->end_reason, assessment::EndReason::aborted);
}

TEST(LiveServer, ATrialCutOffByAKilledServerIsFiledAtTheNextStart) {
  Workplace workplace;
  database::NewTrial trial;
  trial.id = workplace.add_trial("ann");  // shows what a row needs
  const auto finished = database::trial(workplace.store(), trial.id);
  ASSERT_TRUE(finished);
  trial = finished->head;
  trial.id = database::new_id();
  ASSERT_TRUE(database::begin_trial(workplace.store(), trial));

  Server server(workplace.options(), workplace.library());
  ASSERT_TRUE(server.start());
  const auto closed = database::trial(workplace.store(), trial.id);
  ASSERT_TRUE(closed);
  EXPECT_EQ(closed->end_reason, assessment::EndReason::aborted);
}

}  // namespace
}  // namespace app::test
