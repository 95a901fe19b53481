// Comments on trials, and voiding one with a reason.
#include <gtest/gtest.h>

#include "tests/app/server_fixture.h"

namespace app::test {
namespace {

using nlohmann::json;

TEST(Judgement, CommentsAreWrittenReadAndTakenBackByTheirAuthorOnly) {
  RunningServer server;
  const std::string trial = server.workplace.add_trial("ann");
  Client ina = server.client_of("ina"), ada = server.client_of("ada"),
         ann = server.client_of("ann");
  const std::string comments = "/api/trials/" + trial + "/comments";
  const Answer late = ina.post(comments, {{"text", "Slow down here."}, {"time_s", 12.5}});
  ASSERT_EQ(late.status, 201) << late.body;
  EXPECT_EQ(ada.post(comments, {{"text", "<b>Well</b> done."}, {"time_s", nullptr}}).status, 201);
  EXPECT_EQ(ina.post(comments, {{"text", "  \n"}, {"time_s", nullptr}}).status, 400);
  EXPECT_EQ(ina.post(comments, {{"text", "x"}, {"time_s", -1}}).status, 400);
  EXPECT_EQ(ina.post(comments, {{"text", std::string(2001, 'x')}, {"time_s", nullptr}}).status,
            400);
  EXPECT_EQ(ann.post(comments, {{"text", "me too"}, {"time_s", nullptr}}).status, 403);

  // of the whole first; the trainee sees them and may judge nothing
  const json seen = ann.get("/api/trials/" + trial).json();
  ASSERT_EQ(seen["comments"].size(), 2U);
  EXPECT_EQ(seen["comments"][0]["text"], "<b>Well</b> done.");
  EXPECT_EQ(seen["comments"][1]["time_s"], 12.5);
  EXPECT_EQ(seen["comments"][1]["own"], false);
  EXPECT_EQ(seen["may_judge"], false);
  EXPECT_EQ(ina.get("/api/trials/" + trial).json()["may_judge"], true);

  const std::string one = comments + "/" + late.json()["id"].get<std::string>();
  EXPECT_EQ(ada.send("DELETE", one).status, 403);
  EXPECT_EQ(ina.send("DELETE", one).status, 204);
  EXPECT_EQ(ina.send("DELETE", one).status, 404);
  EXPECT_EQ(ann.get("/api/trials/" + trial).json()["comments"].size(), 1U);
}

TEST(Judgement, VoidingNeedsAReasonAndIsSeenByTheTrainee) {
  RunningServer server;
  const std::string trial = server.workplace.add_trial("ann");
  const std::string own = server.workplace.add_trial("ina");
  Client ina = server.client_of("ina"), ann = server.client_of("ann");
  const std::string path = "/api/trials/" + trial + "/void";
  EXPECT_EQ(ina.get("/api/trials/" + trial).json()["void"], nullptr);
  EXPECT_EQ(ina.post(path, {{"reason", "no"}}).status, 400);
  EXPECT_EQ(ann.post(path, {{"reason", "I slipped, sorry about that"}}).status, 403);
  const Answer voided = ina.post(path, {{"reason", "The fire alarm went off."}});
  ASSERT_EQ(voided.status, 200) << voided.body;
  EXPECT_EQ(ina.post(path, {{"reason", "The fire alarm went off."}}).status, 409);
  const json seen = ann.get("/api/trials/" + trial).json();
  EXPECT_EQ(seen["void"]["reason"], "The fire alarm went off.");
  EXPECT_EQ(seen["void"]["voided_by"], voided.json()["void"]["voided_by"]);
  EXPECT_EQ(seen["trial"]["voided"], true);
  EXPECT_EQ(ina.post("/api/trials/" + own + "/void", {{"reason", "I would rather not."}}).status,
            409);
}

}  // namespace
}  // namespace app::test
