#include "curricula/progression.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

using assessment::ExerciseStatus;
using assessment::Outcome;
using curricula::Block;
using curricula::Curriculum;
using curricula::Exercise;
using curricula::ExerciseHistory;
using curricula::Lifecycle;
using curricula::may_start;
using curricula::PastTrial;
using curricula::progression_of;

const std::string kToday = "2026-03-31";
const std::string kYesterday = "2026-03-30";

Exercise exercise(const char* id, const char* title) {
  Exercise result;
  result.id = id;
  result.title = {{"en", title}};
  result.proficiency = assessment::ProficiencyRule{
      .consecutive = 2, .additional = 0, .min_trials = 0, .max_trials = 5};
  return result;
}

// Two blocks: feed and turn in any order, four trials a day; then reach.
Curriculum two_blocks() {
  Curriculum curriculum;
  curriculum.id = "small";
  curriculum.status = Lifecycle::published;
  curriculum.exercises = {exercise("feed", "Feeding"), exercise("turn", "Turning"),
                          exercise("reach", "Reaching")};
  Block first;
  first.id = "first";
  first.title = {{"en", "Basics"}};
  first.exercises = {"feed", "turn"};
  first.max_trials_per_day = 4;
  Block second;
  second.id = "second";
  second.exercises = {"reach"};
  second.after = "first";
  curriculum.plan = {first, second};
  return curriculum;
}

// "++-" on a day: passed, passed, not passed; "x" invalid, "v" voided, "i" interrupted.
ExerciseHistory history(const char* id, const std::string& outcomes, const std::string& date) {
  ExerciseHistory result{id, {}};
  for (const char c : outcomes) {
    PastTrial trial;
    trial.date = date;
    trial.outcome.outcome = c == '-'   ? Outcome::not_passed
                            : c == 'x' ? Outcome::invalid
                                       : Outcome::passed;
    trial.outcome.voided = c == 'v';
    trial.outcome.interrupted = c == 'i';
    result.trials.push_back(trial);
  }
  return result;
}

TEST(Progression, ABeginnerHasTheFirstBlockOpen) {
  const auto progression = progression_of(two_blocks(), {}, kToday);
  ASSERT_EQ(progression.exercises.size(), 3U);
  EXPECT_EQ(progression.find("feed")->progress.status, ExerciseStatus::available);
  EXPECT_TRUE(progression.find("feed")->may_start);
  EXPECT_TRUE(progression.find("turn")->may_start);
  EXPECT_EQ(progression.find("reach")->progress.status, ExerciseStatus::locked);
  EXPECT_FALSE(progression.find("reach")->may_start);
  EXPECT_EQ(progression.find("reach")->why_not, "First become proficient in the block \"Basics\".");
  EXPECT_EQ(progression.find("reach")->block_id, "second");
  EXPECT_EQ(progression.next, "feed");
  EXPECT_FALSE(progression.find_block("second")->unlocked);
  EXPECT_EQ(progression.find("nothing"), nullptr);
  EXPECT_EQ(progression.find_block("nothing"), nullptr);
}

TEST(Progression, ABlockOpensWhenEveryExerciseBeforeItIsProficient) {
  std::vector<ExerciseHistory> histories = {history("feed", "++", kYesterday),
                                            history("turn", "+-", kYesterday)};
  EXPECT_FALSE(progression_of(two_blocks(), histories, kToday).find("reach")->may_start);
  histories[1] = history("turn", "+-++", kYesterday);
  const auto progression = progression_of(two_blocks(), histories, kToday);
  EXPECT_TRUE(progression.find_block("first")->proficient);
  EXPECT_TRUE(progression.find_block("second")->unlocked);
  EXPECT_TRUE(progression.find("reach")->may_start);
  EXPECT_EQ(progression.next, "reach");
}

TEST(Progression, AnExerciseOpensWhenWhatItRequiresIsProficient) {
  Curriculum curriculum = two_blocks();
  curriculum.exercises[1].requires_proficient = {"feed"};
  EXPECT_EQ(progression_of(curriculum, {}, kToday).find("turn")->why_not,
            "First become proficient in \"Feeding\".");
  const std::vector<ExerciseHistory> histories = {history("feed", "++", kYesterday)};
  EXPECT_TRUE(progression_of(curriculum, histories, kToday).find("turn")->may_start);
}

TEST(Progression, AListedOrderOpensOneAfterTheOther) {
  Curriculum curriculum = two_blocks();
  curriculum.plan[0].any_order = false;
  EXPECT_TRUE(progression_of(curriculum, {}, kToday).find("feed")->may_start);
  EXPECT_FALSE(progression_of(curriculum, {}, kToday).find("turn")->may_start);
  const std::vector<ExerciseHistory> histories = {history("feed", "++", kYesterday)};
  EXPECT_TRUE(progression_of(curriculum, histories, kToday).find("turn")->may_start);
}

TEST(Progression, TheDailyMaximumIsOfTheBlockAndOfTheDay) {
  const std::vector<ExerciseHistory> histories = {history("feed", "--", kToday),
                                                  history("turn", "-x", kToday)};
  const auto today = progression_of(two_blocks(), histories, kToday);
  EXPECT_EQ(today.find_block("first")->trials_today, 4);
  EXPECT_FALSE(today.find("feed")->may_start);
  EXPECT_EQ(today.find("feed")->why_not,
            "That was enough for today (4 trials a day): go on tomorrow.");
  EXPECT_TRUE(today.next.empty());
  EXPECT_EQ(today.sentence, today.find("feed")->why_not);

  const auto tomorrow = progression_of(two_blocks(), histories, "2026-04-01");
  EXPECT_EQ(tomorrow.find_block("first")->trials_today, 0);
  EXPECT_TRUE(tomorrow.find("feed")->may_start);
}

TEST(Progression, AVoidedTrialDoesNotCountAgainstTheDay) {
  const std::vector<ExerciseHistory> histories = {history("feed", "--v", kToday),
                                                  history("turn", "i", kToday)};
  const auto progression = progression_of(two_blocks(), histories, kToday);
  EXPECT_EQ(progression.find_block("first")->trials_today, 3);
  EXPECT_TRUE(progression.find("feed")->may_start);
}

TEST(Progression, WhatWasBegunComesNext) {
  const std::vector<ExerciseHistory> histories = {history("turn", "+", kYesterday)};
  EXPECT_EQ(progression_of(two_blocks(), histories, kToday).next, "turn");
}

TEST(Progression, AnExhaustedExerciseNeedsTheInstructor) {
  const std::vector<ExerciseHistory> histories = {history("feed", "-----", kYesterday)};
  const auto progression = progression_of(two_blocks(), histories, kToday);
  EXPECT_EQ(progression.find("feed")->progress.status, ExerciseStatus::exhausted);
  EXPECT_FALSE(progression.find("feed")->may_start);
  EXPECT_NE(progression.find("feed")->why_not.find("All 5 trials"), std::string::npos);
  EXPECT_EQ(progression.next, "turn");
}

TEST(Progression, AProficientPersonMayGoOnPractising) {
  const std::vector<ExerciseHistory> histories = {history("feed", "++", kYesterday),
                                                  history("turn", "++", kYesterday),
                                                  history("reach", "++", kYesterday)};
  const auto progression = progression_of(two_blocks(), histories, kToday);
  EXPECT_TRUE(progression.find("feed")->may_start);
  EXPECT_TRUE(progression.next.empty());
  EXPECT_EQ(progression.sentence, "You are proficient in every exercise of this curriculum.");
}

TEST(Progression, AnExerciseWithoutProficiencyIsForPractice) {
  Curriculum curriculum = two_blocks();
  curriculum.exercises[0].proficiency.reset();
  const std::vector<ExerciseHistory> histories = {history("feed", "+x", kYesterday)};
  const auto progression = progression_of(curriculum, histories, kToday);
  EXPECT_EQ(progression.find("feed")->progress.status, ExerciseStatus::practised);
  EXPECT_EQ(progression.find("feed")->progress.started, 2);
  EXPECT_EQ(progression.find("feed")->progress.counted, 1);
  EXPECT_TRUE(progression.find("feed")->may_start);
  EXPECT_EQ(progression.next, "turn");  // nothing is to be reached in feed
}

TEST(Progression, ExercisesOutsideThePlanComeLast) {
  Curriculum curriculum = two_blocks();
  curriculum.exercises.insert(curriculum.exercises.begin(), exercise("extra", "Extra"));
  const auto progression = progression_of(curriculum, {}, kToday);
  ASSERT_EQ(progression.exercises.size(), 4U);
  EXPECT_EQ(progression.exercises.back().exercise_id, "extra");
  EXPECT_TRUE(progression.exercises.back().block_id.empty());
}

TEST(MayStart, SaysYesOrWhyNot) {
  const Curriculum curriculum = two_blocks();
  EXPECT_TRUE(may_start(curriculum, {}, kToday, "feed").has_value());
  const auto locked = may_start(curriculum, {}, kToday, "reach");
  ASSERT_FALSE(locked.has_value());
  EXPECT_EQ(locked.error().code, base::ErrorCode::denied);
  EXPECT_EQ(locked.error().message, "First become proficient in the block \"Basics\".");
  const auto unknown = may_start(curriculum, {}, kToday, "nothing");
  ASSERT_FALSE(unknown.has_value());
  EXPECT_EQ(unknown.error().code, base::ErrorCode::not_found);
}

TEST(MayStart, OnlyAPublishedCurriculumCanBeTrained) {
  Curriculum curriculum = two_blocks();
  curriculum.status = Lifecycle::draft;
  EXPECT_EQ(may_start(curriculum, {}, kToday, "feed").error().message,
            "This curriculum is a draft: publish it first.");
  curriculum.status = Lifecycle::retired;
  EXPECT_EQ(may_start(curriculum, {}, kToday, "feed").error().code, base::ErrorCode::denied);
}

}  // namespace
