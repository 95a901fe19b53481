// How a person gets on, as the pages read it: every metric small, where it stands, the experts.
#include <gtest/gtest.h>

#include "app/server/expert_bands.h"
#include "database/curricula.h"
#include "database/trials.h"
#include "tests/app/server_fixture.h"

namespace {

using app::test::RunningServer;
using nlohmann::json;

constexpr const char* kLongAgo = "2020-01-01T00:00:00.000Z";

struct Made {
  double time_s = 80.0;
  assessment::EndReason end = assessment::EndReason::completed;
  bool interrupted = false;
  assessment::Source source = assessment::Source::live;
  std::vector<assessment::Event> events = {};
};

std::string add_trial(database::Store& store, const std::string& person_id, const Made& made) {
  database::NewTrial trial;
  trial.id = database::new_id();
  trial.person_id = person_id;
  trial.exercise_id = "linear";
  trial.exercise_version_id = (*database::current_exercise(store, "vascular-basics", "linear")).id;
  trial.source = made.source;
  trial.apparatus = "cathedra";
  trial.device = "keyboard";
  EXPECT_TRUE(database::begin_trial(store, trial));
  database::FinishedTrial finished;
  finished.end_reason = made.end;
  finished.interrupted = made.interrupted;
  finished.metrics = {{"time_s", 1, made.time_s}, {"path_economy", 1, 10.0 / made.time_s}};
  finished.verdict.outcome = made.end == assessment::EndReason::completed
                                 ? assessment::Outcome::passed
                                 : assessment::Outcome::not_passed;
  finished.rule_version = "linear@1";
  EXPECT_TRUE(database::finish_trial(store, trial.id, finished, {}, made.events));
  return trial.id;
}

std::string add_expert(database::Store& store, int number, database::PersonKind kind) {
  database::NewPerson person;
  person.name = "expert" + std::to_string(number);
  person.display_name = person.name;
  person.kind = kind;
  person.level = database::Level::expert;
  person.level_declared_utc = kLongAgo;
  return (*database::add_person(store, person, "system")).id;
}

json linear_of(RunningServer& running, const std::string& name) {
  const json answer = running.client_of(name).get("/api/people/me/progress").json();
  for (const json& exercise : answer.at("exercises")) {
    if (exercise.at("exercise_id") == "linear") return exercise;
  }
  return {};
}

json standing_of(const json& exercise, const std::string& metric) {
  for (const json& standing : exercise.at("standings")) {
    if (standing.at("metric") == metric) return standing;
  }
  return {};
}

TEST(Progress, HasOneSmallDrawingAndOneStandingPerRecordedMetric) {
  RunningServer running;
  auto& store = running.workplace.store();
  const std::string ann = running.workplace.id_of("ann");
  add_trial(store, ann, {.time_s = 100.0});
  add_trial(store, ann, {.time_s = 40.0, .interrupted = true});
  add_trial(store, ann, {.time_s = 80.0});

  const json linear = linear_of(running, "ann");
  const json record = running.client_of("ann").get("/api/exercises/linear").json().at("record");
  ASSERT_EQ(linear.at("small_multiples").size(), record.size());
  ASSERT_EQ(linear.at("standings").size(), record.size());
  for (std::size_t i = 0; i < record.size(); ++i) {
    EXPECT_EQ(linear["standings"][i]["metric"], record[i]);
  }
  const json time = standing_of(linear, "time_s");
  EXPECT_EQ(time["last"], 80.0);
  EXPECT_EQ(time["previous"], 100.0);  // the interrupted trial is not counted
  EXPECT_EQ(time["best"], 80.0);
  EXPECT_EQ(time["change_to_first_percent"], -20.0);
  EXPECT_EQ(standing_of(linear, "path_economy")["best"], 10.0 / 80.0);  // more is better
  EXPECT_EQ(standing_of(linear, "speed_max_mm_s")["last"], nullptr);    // none has it
}

TEST(Progress, CountsTheCriticalErrorsOfEachTrial) {
  RunningServer running;
  auto& store = running.workplace.store();
  const std::string ann = running.workplace.id_of("ann");
  using assessment::Severity;
  add_trial(store, ann,
            {.events = {{1.0, "limit_breached", Severity::critical, "force_max_n", 2.5},
                        {2.0, "wall_hit", Severity::mark, "", 0.2},
                        {3.0, "limit_breached", Severity::critical, "force_max_n", 2.6}}});
  add_trial(store, ann, {});
  const json trials = linear_of(running, "ann").at("trials");  // newest first
  ASSERT_EQ(trials.size(), 2U);
  EXPECT_EQ(trials[0]["critical_errors"], 0);
  EXPECT_EQ(trials[1]["critical_errors"], 2);
}

TEST(Progress, DoesNotSayNoTrialWhenNoneWasCompleted) {
  RunningServer running;
  add_trial(running.workplace.store(), running.workplace.id_of("ann"),
            {.end = assessment::EndReason::timeout});
  const json linear = linear_of(running, "ann");
  EXPECT_NE(linear["headline"].get<std::string>().find(": 1 trial, none completed;"),
            std::string::npos)
      << linear["headline"];
}

TEST(Progress, ShowsTheExpertsFromFiveLiveOnesOn) {
  RunningServer running;
  auto& store = running.workplace.store();
  using database::PersonKind;
  for (int i = 1; i <= 4; ++i) {
    const std::string id = add_expert(store, i, PersonKind::live);
    // every expert counts once: many trials of one weigh no more
    for (int n = 0; n < i; ++n) add_trial(store, id, {.time_s = 10.0 * i});
  }
  const std::string robot = add_expert(store, 100, PersonKind::simulated);
  add_trial(store, robot, {.time_s = 1.0, .source = assessment::Source::simulated_operator});
  EXPECT_TRUE((*app::expert_bands(store)).empty());

  const std::string fifth = add_expert(store, 5, PersonKind::live);
  add_trial(store, fifth, {.time_s = 50.0});
  add_trial(store, fifth, {.time_s = 5000.0, .interrupted = true});
  const auto bands = app::expert_bands(store);
  ASSERT_TRUE(bands);
  const app::ExpertBand band = (*bands).at({"linear", "time_s"});
  EXPECT_EQ(band.experts, 5);
  EXPECT_EQ(band.low, 20.0);
  EXPECT_EQ(band.median, 30.0);
  EXPECT_EQ(band.high, 40.0);

  add_trial(store, running.workplace.id_of("ann"), {});
  const json linear = linear_of(running, "ann");
  EXPECT_NE(linear["charts"][0]["svg"].get<std::string>().find("Experts, middle half"),
            std::string::npos);
}

}  // namespace
