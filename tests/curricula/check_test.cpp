#include "curricula/check.h"

#include <cstdint>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "tests/curricula/valid_curriculum.h"

namespace {

using assessment::Comparison;
using assessment::Rule;
using curricula::check;
using curricula::Consequence;
using curricula::Curriculum;
using curricula::Exercise;
using curricula::Lifecycle;
using curricula::Step;
using test::replaced;
using test::small_catalogue;
using test::valid_curriculum;

Curriculum read_valid() {
  auto result = check(valid_curriculum(), small_catalogue());
  for (const auto& problem : result.problems)
    ADD_FAILURE() << problem.line << ": " << problem.message;
  return result.curriculum.value_or(Curriculum{});
}

TEST(Check, ReadsWhoAndWhatTheCurriculumIs) {
  const Curriculum curriculum = read_valid();

  EXPECT_EQ(curriculum.id, "small");
  EXPECT_EQ(curriculum.version, "1.2.0");
  EXPECT_EQ(curriculum.status, Lifecycle::published);
  EXPECT_EQ(curriculum.title.at("en"), "Small");
  EXPECT_EQ(curriculum.title.at("de"), "Klein");
  EXPECT_EQ(curriculum.authors, std::vector<std::string>{"somebody"});
  EXPECT_EQ(curriculum.yaml, valid_curriculum());
}

TEST(Check, FingerprintIsTheSha256OfTheBytes) {
  // printf 'schema: ...' | sha256sum of a file that is valid is not at hand here; the empty file's
  // fingerprint is published and the function is tested on it in catalogue_test.cpp
  const Curriculum curriculum = read_valid();
  EXPECT_EQ(curriculum.sha256.size(), 64U);
  const auto other = check(valid_curriculum() + "# a comment\n", small_catalogue());
  ASSERT_TRUE(other.ok());
  EXPECT_NE(other.curriculum->sha256, curriculum.sha256);
}

TEST(Check, ReadsAnExercise) {
  const Curriculum curriculum = read_valid();
  const Exercise* feed = curriculum.find("feed");
  ASSERT_NE(feed, nullptr);

  EXPECT_EQ(feed->version, 3);
  EXPECT_EQ(feed->title.at("en"), "Feed");
  EXPECT_EQ(feed->goal.at("en"), "Feed it.");
  EXPECT_EQ(feed->scene.anatomy, "tube");
  EXPECT_EQ(feed->scene.instruments, std::vector<std::string>{"wire"});
  EXPECT_EQ(feed->scene.start, 50.0);
  EXPECT_EQ(feed->scene.seed, 9U);
  EXPECT_EQ(feed->record, (std::vector<std::string>{"time_s", "force_max_n"}));
  ASSERT_TRUE(feed->proficiency.has_value());
  EXPECT_EQ(feed->proficiency->consecutive, 2);
  EXPECT_EQ(feed->proficiency->additional, 1);
  EXPECT_EQ(feed->proficiency->min_trials, 3);
  EXPECT_EQ(feed->proficiency->max_trials, 40);
  EXPECT_TRUE(feed->requires_proficient.empty());
  EXPECT_EQ(curriculum.find("turn")->requires_proficient, std::vector<std::string>{"feed"});
}

TEST(Check, ReadsStepsInTheUnitsOfTheProgram) {
  const Curriculum curriculum = read_valid();
  const auto& feed = curriculum.find("feed")->steps;
  ASSERT_EQ(feed.size(), 3U);
  EXPECT_EQ(feed[0].kind, Step::Kind::translate);
  EXPECT_EQ(feed[0].id, "there");
  EXPECT_EQ(feed[0].target, 300.0);
  EXPECT_EQ(feed[0].tolerance, 2.0);
  EXPECT_EQ(feed[0].hold, 1.0);
  EXPECT_EQ(feed[1].kind, Step::Kind::hold);
  EXPECT_EQ(feed[1].seconds, 3.0);
  EXPECT_EQ(feed[2].target, -50.0);
  EXPECT_EQ(feed[2].hold, 0.0);

  const auto& turn = curriculum.find("turn")->steps;
  ASSERT_EQ(turn.size(), 1U);
  EXPECT_EQ(turn[0].kind, Step::Kind::repeat);
  EXPECT_EQ(turn[0].times, 2);
  ASSERT_EQ(turn[0].steps.size(), 2U);
  EXPECT_DOUBLE_EQ(turn[0].steps[0].target, std::numbers::pi);            // 180 degrees
  EXPECT_DOUBLE_EQ(turn[0].steps[0].tolerance, std::numbers::pi / 36.0);  // 5 degrees
  EXPECT_EQ(turn[0].steps[1].hold, 0.5);
}

TEST(Check, ReadsLimitsAndTheirConsequences) {
  const auto limits = read_valid().find("feed")->limits;
  ASSERT_EQ(limits.size(), 2U);
  EXPECT_EQ(limits[0].metric, "force_max_n");
  EXPECT_EQ(limits[0].comparison, Comparison::less_equal);
  EXPECT_EQ(limits[0].bound, 1.5);
  EXPECT_EQ(limits[0].on_breach, Consequence::critical_error);
  EXPECT_EQ(limits[1].comparison, Comparison::less);
  EXPECT_EQ(limits[1].on_breach, Consequence::mark);
}

TEST(Check, ResolvesABenchmarkIntoTheBoundOfTheRule) {
  const Curriculum curriculum = read_valid();
  const auto& pass = curriculum.find("feed")->pass;
  ASSERT_TRUE(pass.has_value());
  EXPECT_EQ(pass->kind, Rule::Kind::all);
  ASSERT_EQ(pass->children.size(), 2U);
  EXPECT_EQ(pass->children[0].kind, Rule::Kind::metric);
  EXPECT_EQ(pass->children[0].subject, "time_s");
  EXPECT_EQ(pass->children[0].bound, 90.0);
  EXPECT_EQ(pass->children[0].benchmark, "quick");
  EXPECT_TRUE(pass->children[0].provisional);
  EXPECT_EQ(pass->children[1].kind, Rule::Kind::errors);
  EXPECT_EQ(pass->children[1].subject, "critical");
  EXPECT_EQ(pass->children[1].comparison, Comparison::equal);
  ASSERT_EQ(curriculum.benchmarks.size(), 1U);
  EXPECT_EQ(curriculum.benchmarks[0].reason.at("en"), "a guess");
}

TEST(Check, ReadsAnyNotAndGoalRules) {
  const auto pass = read_valid().find("turn")->pass;
  ASSERT_TRUE(pass.has_value());
  EXPECT_EQ(pass->kind, Rule::Kind::any);
  ASSERT_EQ(pass->children.size(), 2U);
  EXPECT_EQ(pass->children[0].kind, Rule::Kind::negate);
  ASSERT_EQ(pass->children[0].children.size(), 1U);
  EXPECT_EQ(pass->children[0].children[0].comparison, Comparison::greater);
  EXPECT_EQ(pass->children[1].kind, Rule::Kind::goal);
  EXPECT_EQ(pass->children[1].subject, "reached");
}

TEST(Check, DefaultsApplyWhereAnExerciseSaysNothing) {
  const Curriculum curriculum = read_valid();
  const Exercise& feed = *curriculum.find("feed");
  EXPECT_EQ(feed.attempt.time_limit, 300.0);
  EXPECT_FALSE(feed.attempt.timeout_fails);
  EXPECT_TRUE(feed.attempt.abort_fails);
  EXPECT_EQ(feed.feedback_during, std::vector<std::string>{"force"});
  EXPECT_EQ(feed.feedback_after, std::vector<std::string>{"time"});

  // key by key: what the exercise leaves out still comes from the defaults
  const Exercise& turn = *curriculum.find("turn");
  EXPECT_EQ(turn.attempt.time_limit, 60.0);
  EXPECT_FALSE(turn.attempt.timeout_fails);
  EXPECT_EQ(turn.feedback_during, std::vector<std::string>{"force"});
  EXPECT_EQ(turn.feedback_after, std::vector<std::string>{"metrics"});
}

TEST(Check, ReadsThePlan) {
  const auto plan = read_valid().plan;
  ASSERT_EQ(plan.size(), 2U);
  EXPECT_EQ(plan[0].id, "first");
  EXPECT_EQ(plan[0].max_trials_per_day, 4);
  EXPECT_TRUE(plan[0].any_order);
  EXPECT_TRUE(plan[0].after.empty());
  EXPECT_EQ(plan[1].title.at("en"), "Second");
  EXPECT_EQ(plan[1].after, "first");
  EXPECT_FALSE(plan[1].any_order);
}

TEST(Check, EachExerciseKeepsItsOwnText) {
  const Curriculum curriculum = read_valid();
  const std::string& feed = curriculum.find("feed")->yaml;
  EXPECT_TRUE(feed.starts_with("id: feed\nversion: 3\n")) << feed;
  EXPECT_TRUE(feed.ends_with(
      "proficiency: {consecutive: 2, additional: 1, min_trials: 3, max_trials: 40}\n"))
      << feed;
  const std::string& turn = curriculum.find("turn")->yaml;
  EXPECT_TRUE(turn.starts_with("id: turn\n")) << turn;
  EXPECT_TRUE(turn.ends_with("proficiency: {consecutive: 1}\n")) << turn;
  // inner indentation survives, the outer is gone
  EXPECT_NE(turn.find("\n  - repeat: 2\n    steps:\n      - {id: cw"), std::string::npos) << turn;
}

TEST(Check, AcceptsWindowsLineEndsAndAByteOrderMark) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : valid_curriculum())
    text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_TRUE(check(text, small_catalogue()).ok());
}

TEST(Check, WarningsDoNotStopACurriculum) {
  const auto result =
      check(replaced(valid_curriculum(), "sign_off: instructor}",
                     "retention_test: {after_days: 42, exercises: [feed], trials: 2}}"),
            small_catalogue());
  EXPECT_TRUE(result.ok());
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_EQ(result.problems[0].severity, curricula::Problem::Severity::warning);
  EXPECT_EQ(result.problems[0].line, 50);
}

// Whatever arrives, there is an answer: the curriculum, or a problem with a place.
TEST(Check, SurvivesTwoThousandBrokenFiles) {
  const std::string valid = valid_curriculum();
  const std::string pieces[] = {"- ",    "? ", ": ", "&a ", "*a ",  "!t ", "{",
                                "}",     "[",  "]",  "\"",  "'",    "|\n", "\t",
                                "---\n", "#",  "\n", "<<",  "\xFF", "\x04"};
  std::mt19937 random(20260101);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  int accepted = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string text = valid;
    for (std::size_t k = 1 + below(6); k > 0; --k) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
        case 0:
          text.insert(at, pieces[below(std::size(pieces))]);
          break;
        case 1:
          text.erase(at, 1 + below(12));
          break;
        case 2:
          text[at] = static_cast<char>(below(256));
          break;
        default:
          text.insert(at, text.substr(below(text.size()), below(150)));
          break;
      }
    }
    if (below(8) == 0) text.resize(below(text.size()));

    const auto result = check(text, small_catalogue());

    accepted += result.ok() ? 1 : 0;
    ASSERT_TRUE(result.ok() || !result.problems.empty()) << text;
    int line_before = 1;
    for (const auto& problem : result.problems) {
      ASSERT_GE(problem.line, line_before) << text;
      ASSERT_GE(problem.column, 1);
      ASSERT_FALSE(problem.message.empty());
      line_before = problem.line;
    }
  }
  EXPECT_LT(accepted, 1000);  // most of the changes did break something
}

}  // namespace
