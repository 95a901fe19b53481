// Novices against experts through the server, on the published trials of the paper. The expected
// numbers are those the paper's tables give, worked out outside this program.
#include <gtest/gtest.h>

#include "app/session/published_data.h"
#include "tests/app/server_fixture.h"

namespace app::test {
namespace {

void load_paper(RunningServer& running) {
  const auto loaded = load_published_data(running.workplace.store(),
                                          CATHEDRA_SOURCE_DIR "/app/demo/published_trials.csv");
  ASSERT_TRUE(loaded) << loaded.error().message;
  ASSERT_EQ(*loaded, 120);
}

TEST(Compare, ThePapersLinearTaskGivesThePublishedMeansAndTheExactTest) {
  RunningServer running;
  load_paper(running);
  Client client = running.client_of("ina");
  const Answer answer = client.get("/api/compare/linear?dataset=paper");
  ASSERT_EQ(answer.status, 200) << answer.body;
  const nlohmann::json comparison = answer.json();
  EXPECT_EQ(comparison["enough"], true);
  // tolerances: half a unit of the last digit of the values given
  ASSERT_EQ(comparison["groups"].size(), 2U);
  EXPECT_EQ(comparison["groups"][0]["level"], "expert");
  EXPECT_NEAR(comparison["groups"][0]["mean_s"].get<double>(), 237.33, 0.005);
  EXPECT_NEAR(comparison["groups"][1]["mean_s"].get<double>(), 390.8, 0.05);
  EXPECT_EQ(comparison["test"]["u"], 0.0);
  EXPECT_NEAR(comparison["test"]["p"].get<double>(), 0.1, 1e-12);
  EXPECT_NEAR(comparison["effect"]["hedges_g"].get<double>(), -6.22, 0.005);
  EXPECT_NEAR(comparison["effect"]["low"].get<double>(), -10.55, 0.005);
  EXPECT_NEAR(comparison["effect"]["high"].get<double>(), -1.93, 0.005);
  EXPECT_EQ(comparison["charts"].size(), 5U);
}

TEST(Compare, TheReportIsDownloadedAsCsvAndAsAPageThatMayDoNothing) {
  RunningServer running;
  load_paper(running);
  Client client = running.client_of("ina");
  const Answer csv = client.get("/api/compare/linear.csv?dataset=paper");
  EXPECT_EQ(csv.status, 200);
  EXPECT_EQ(csv.header("content-type"), "text/csv; charset=utf-8");
  EXPECT_NE(csv.header("content-disposition").find("attachment"), std::string::npos);
  const Answer page = client.get("/api/compare/linear.html?dataset=paper");
  EXPECT_EQ(page.status, 200);
  EXPECT_NE(page.header("content-security-policy").find("default-src 'none'"), std::string::npos);
}

TEST(Compare, DatasetsAreListedAndNeverPooled) {
  RunningServer running;
  load_paper(running);
  const nlohmann::json body = running.client_of("ada").get("/api/compare").json();
  ASSERT_EQ(body["choices"].size(), 2U);
  for (const auto& choice : body["choices"]) {
    EXPECT_EQ(choice["dataset"], "paper");
    EXPECT_EQ(choice["people"], 6);
    EXPECT_EQ(choice["trials"], 60);
  }
}

TEST(Compare, UnknownExercisesAndDatasetsAreProblems) {
  RunningServer running;
  Client client = running.client_of("ina");
  EXPECT_EQ(client.get("/api/compare/none?dataset=paper").status, 404);
  EXPECT_EQ(client.get("/api/compare/linear?dataset=all").status, 400);
}

// A novice and an expert in group A, with a trial each.
void add_live_pair(Workplace& workplace) {
  const std::string expert = workplace.id_of("ina"), novice = workplace.id_of("ann");
  ASSERT_TRUE(database::declare_experience(workplace.store(), expert, database::Level::expert, 900,
                                           "system"));
  ASSERT_TRUE(database::declare_experience(workplace.store(), novice, database::Level::novice, 0,
                                           "system"));
  workplace.add_trial("ina");
  workplace.add_trial("ann");
}

TEST(Compare, FewLivePeopleAreShownToTheirInstructorOnly) {
  RunningServer running;
  add_live_pair(running.workplace);
  for (const char* name : {"ada", "rex"}) {
    const Answer answer = running.client_of(name).get("/api/compare/linear?dataset=live");
    ASSERT_EQ(answer.status, 200) << answer.body;
    EXPECT_EQ(answer.json()["enough"], false) << name;
    EXPECT_EQ(answer.json()["groups"].size(), 0U) << name;
    EXPECT_EQ(answer.json()["charts"].size(), 0U) << name;
    EXPECT_EQ(answer.body.find("The ann"), std::string::npos) << name;
    EXPECT_EQ(running.client_of(name).get("/api/compare/linear.csv?dataset=live").status, 422);
  }
  const Answer own = running.client_of("ina").get("/api/compare/linear?dataset=live");
  EXPECT_NE(own.body.find("The ann"), std::string::npos);
}

}  // namespace
}  // namespace app::test
