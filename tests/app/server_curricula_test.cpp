// Curricula over HTTP: copy, mistake, mend, publish; and what is refused on the way.
#include <string>

#include <gtest/gtest.h>

#include "database/training_by.h"
#include "tests/app/server_fixture.h"

namespace app::test {
namespace {

using nlohmann::json;

constexpr const char* kDraft = "/api/curricula/our-basics/draft";

class CurriculaRoutes : public testing::Test {
 protected:
  RunningServer running_;
  Client ada_ = running_.client_of("ada");

  json copy() {
    const Answer answer = ada_.post(
        "/api/curricula",
        {{"from_id", "vascular-basics"}, {"from_version", "1.0.0"}, {"new_id", "our-basics"}});
    EXPECT_EQ(answer.status, 201) << answer.body;
    return answer.json();
  }
  Answer put(const std::string& target, const json& body) {
    return ada_.send("PUT", target, body.dump(), {{"Content-Type", "application/json"}});
  }
  Answer save(const std::string& yaml, const std::string& replaces) {
    return put(kDraft, {{"yaml", yaml}, {"replaces_sha256", replaces}});
  }
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST_F(CurriculaRoutes, ACopyIsADraftOfItsOwnThatIsInOrder) {
  const json draft = copy();
  EXPECT_EQ(draft["id"], "our-basics");
  EXPECT_EQ(draft["status"], "draft");
  EXPECT_EQ(draft["check"]["ok"], true) << draft["check"];
  EXPECT_FALSE(draft["check"]["outline"].empty());
  EXPECT_EQ(draft["check"]["outline"][0]["briefing"]["status"], "available");
  EXPECT_GT(draft["check"]["outline"][0]["line"], 1);
  EXPECT_EQ(ada_.post("/api/curricula", {{"from_id", "vascular-basics"},
                                         {"from_version", "1.0.0"},
                                         {"new_id", "our-basics"}})
                .status,
            409);
  EXPECT_EQ(ada_.post("/api/curricula", {{"from_id", "vascular-basics"},
                                         {"from_version", "1.0.0"},
                                         {"new_id", "vascular-basics"}})
                .status,
            409);
}

TEST_F(CurriculaRoutes, AMistakeIsSavedMarkedAndNotPublished) {
  const json draft = copy();
  const std::string broken = replaced(draft["yaml"], "force_max_n", "force_mx_n");
  const json saved = save(broken, draft["sha256"]).json();
  EXPECT_EQ(saved["check"]["ok"], false);
  EXPECT_GE(saved["check"]["errors"], 1);
  EXPECT_GT(saved["check"]["problems"][0]["line"], 1);
  const Answer refused =
      ada_.post("/api/curricula/our-basics/publish", {{"sha256", saved["sha256"]}});
  EXPECT_EQ(refused.status, 409);
  EXPECT_NE(refused.body.find("Line "), std::string::npos) << refused.body;
}

TEST_F(CurriculaRoutes, SavingOverSomebodyElsesTextIsAConflictThatNamesThem) {
  const json draft = copy();
  ASSERT_EQ(save(std::string(draft["yaml"]) + "# one\n", draft["sha256"]).status, 200);
  const Answer refused = save(std::string(draft["yaml"]) + "# two\n", draft["sha256"]);
  EXPECT_EQ(refused.status, 409);
  EXPECT_NE(refused.body.find("saved this draft at"), std::string::npos) << refused.body;
  EXPECT_EQ(save(replaced(draft["yaml"], "id: our-basics", "id: other"), draft["sha256"]).status,
            400);
}

TEST_F(CurriculaRoutes, PublishedItIsAVersionAndTheDraftIsGone) {
  const json draft = copy();
  const Answer answer =
      ada_.post("/api/curricula/our-basics/publish", {{"sha256", draft["sha256"]}});
  ASSERT_EQ(answer.status, 200) << answer.body;
  EXPECT_EQ(answer.json()["status"], "published");
  EXPECT_NE(std::string(answer.json()["yaml"]).find("status: published"), std::string::npos);
  EXPECT_EQ(ada_.get("/api/curricula/our-basics/versions/draft").status, 404);

  // nobody's training changes until it is the default
  const json list = ada_.get("/api/curricula").json();
  for (const json& row : list["curricula"]) {
    EXPECT_EQ(row["is_default"], row["id"] == "vascular-basics") << row;
  }
  const Answer changed = put("/api/curricula/default", {{"curriculum_id", "our-basics"}});
  EXPECT_EQ(changed.status, 200) << changed.body;
  EXPECT_EQ(ada_.post("/api/curricula/our-basics/retire", {{"version", "1.0.0"}}).status, 409);
  EXPECT_EQ(ada_.post("/api/curricula/vascular-basics/retire", {{"version", "1.0.0"}}).status, 200);
}

TEST_F(CurriculaRoutes, TheNextVersionMustSayHowMuchItChanges) {
  const json first = copy();
  ASSERT_EQ(ada_.post("/api/curricula/our-basics/publish", {{"sha256", first["sha256"]}}).status,
            200);
  const Answer next =
      ada_.post("/api/curricula",
                {{"from_id", "our-basics"}, {"from_version", "1.0.0"}, {"new_id", "our-basics"}});
  ASSERT_EQ(next.status, 201) << next.body;
  const json draft = next.json();
  EXPECT_EQ(draft["version"], "1.0.1");
  const json saved =
      save(replaced(draft["yaml"], "to_mm: 350", "to_mm: 340"), draft["sha256"]).json();
  EXPECT_EQ(saved["check"]["ok"], false);
  EXPECT_NE(saved["check"].dump().find("write 2.0.0"), std::string::npos) << saved["check"];
  const json diff = ada_.get("/api/curricula/our-basics/diff?from=1.0.0&to=draft").json();
  EXPECT_EQ(diff["needed_bump"], "major");
  int removed = 0, added = 0, gaps = 0;
  for (const json& line : diff["lines"]) {
    removed += line["kind"] == "removed" ? 1 : 0;
    added += line["kind"] == "added" ? 1 : 0;
    gaps += line["kind"] == "gap" ? 1 : 0;
  }
  EXPECT_EQ(removed, 3) << diff;  // version, status, step
  EXPECT_EQ(added, 3);
  EXPECT_GE(gaps, 1);
  EXPECT_EQ(ada_.send("DELETE", kDraft).status, 204);
  EXPECT_EQ(ada_.send("DELETE", kDraft).status, 404);
}

TEST_F(CurriculaRoutes, ATraineeTrainsByTheAssignedCurriculumAndItsTrialsAlone) {
  const json draft = copy();
  ASSERT_EQ(ada_.post("/api/curricula/our-basics/publish", {{"sha256", draft["sha256"]}}).status,
            200);
  running_.workplace.add_trial("ann");  // of vascular-basics
  Client ann = running_.client_of("ann");
  const auto trials = [&] {
    int count = 0;
    const json progress = ann.get("/api/people/me/progress").json();
    for (const json& exercise : progress["exercises"]) {
      count += static_cast<int>(exercise["trials"].size());
    }
    return count;
  };
  EXPECT_EQ(trials(), 1);
  ASSERT_TRUE(database::assign_curriculum(running_.workplace.store(),
                                          running_.workplace.id_of("ann"), "our-basics", "system"));
  EXPECT_EQ(trials(), 0);
}

TEST_F(CurriculaRoutes, InstrumentsCarryTheirDrawings) {
  const json instruments = ada_.get("/api/instruments").json()["instruments"];
  ASSERT_FALSE(instruments.empty());
  for (const json& each : instruments) {
    ASSERT_EQ(each["charts"].size(), 2u);
    EXPECT_TRUE(std::string(each["charts"][0]["svg"]).starts_with("<svg"));
    EXPECT_FALSE(each["used_by"].empty() && each["info"]["id"] == "guidewire-035-straight");
  }
  const json catalogue = ada_.get("/api/catalogue").json();
  EXPECT_FALSE(catalogue["anatomies"].empty());
  EXPECT_FALSE(catalogue["metrics"].empty());
}

}  // namespace
}  // namespace app::test
