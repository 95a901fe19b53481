#include "assessment/proficiency.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace assessment {
namespace {

// P passed, f not passed, i invalid, V a voided pass, X an interrupted pass.
std::vector<TrialOutcome> trials(const std::string& letters) {
  std::vector<TrialOutcome> outcomes;
  for (const char letter : letters) {
    switch (letter) {
      case 'P':
        outcomes.push_back({Outcome::passed});
        break;
      case 'f':
        outcomes.push_back({Outcome::not_passed});
        break;
      case 'V':
        outcomes.push_back({Outcome::passed, true, false});
        break;
      case 'X':
        outcomes.push_back({Outcome::passed, false, true});
        break;
      default:
        outcomes.push_back({Outcome::invalid});
    }
  }
  return outcomes;
}

const ProficiencyRule kTwoInARow{.consecutive = 2};

ExerciseStatus status(const ProficiencyRule& rule, const std::string& letters,
                      bool unlocked = true) {
  return progress_of(rule, trials(letters), unlocked).status;
}

TEST(Proficiency, GoesFromAvailableOverPractisedToProficient) {
  EXPECT_EQ(status(kTwoInARow, ""), ExerciseStatus::available);
  EXPECT_EQ(status(kTwoInARow, "i"), ExerciseStatus::in_progress);
  EXPECT_EQ(status(kTwoInARow, "f"), ExerciseStatus::practised);
  EXPECT_EQ(status(kTwoInARow, "PfP"), ExerciseStatus::practised);
  EXPECT_EQ(status(kTwoInARow, "PfPP"), ExerciseStatus::proficient);
}

TEST(Proficiency, OnceReachedItStays) {
  EXPECT_EQ(status(kTwoInARow, "PPffff"), ExerciseStatus::proficient);
  EXPECT_EQ(status(kTwoInARow, "PPffff", false), ExerciseStatus::proficient);
  EXPECT_EQ(status({.consecutive = 2, .max_trials = 3}, "PPfff"), ExerciseStatus::proficient);
}

TEST(Proficiency, WhatDoesNotCountNeitherHelpsNorBreaksARow) {
  EXPECT_EQ(status(kTwoInARow, "VX"), ExerciseStatus::in_progress);
  EXPECT_EQ(status(kTwoInARow, "PV"), ExerciseStatus::practised);
  EXPECT_EQ(status(kTwoInARow, "PVXiP"), ExerciseStatus::proficient);
  const Progress progress = progress_of(kTwoInARow, trials("PVXif"), true);
  EXPECT_EQ(progress.started, 5);
  EXPECT_EQ(progress.counted, 2);
  EXPECT_EQ(progress.passes, 1);
  EXPECT_EQ(progress.in_a_row, 0);
}

TEST(Proficiency, NeedsTheFewestTrials) {
  const ProficiencyRule rule{.consecutive = 2, .min_trials = 4};
  EXPECT_EQ(status(rule, "PP"), ExerciseStatus::practised);
  EXPECT_EQ(status(rule, "PPf"), ExerciseStatus::practised);
  EXPECT_EQ(status(rule, "PPff"), ExerciseStatus::proficient);
  EXPECT_EQ(progress_of(rule, trials("PP"), true).sentence,
            "2 passes in a row reached, 2 of at least 4 trials");
}

TEST(Proficiency, AdditionalPassesMayComeAnywhereAfterTheRow) {
  const ProficiencyRule rule{.consecutive = 2, .additional = 2};
  EXPECT_EQ(status(rule, "PPP"), ExerciseStatus::practised);
  EXPECT_EQ(status(rule, "PPPfP"), ExerciseStatus::proficient);
  EXPECT_EQ(status(rule, "PfPfPP"), ExerciseStatus::practised);  // those before do not count
  EXPECT_EQ(progress_of(rule, trials("PPfP"), true).sentence,
            "2 passes in a row reached, 1 of 2 further passes");
}

TEST(Proficiency, TrialsRunOut) {
  const ProficiencyRule rule{.consecutive = 2, .max_trials = 4};
  EXPECT_EQ(status(rule, "fPf"), ExerciseStatus::practised);
  EXPECT_EQ(status(rule, "fPff"), ExerciseStatus::exhausted);
  EXPECT_EQ(status(rule, "ffPP"), ExerciseStatus::proficient);
  EXPECT_EQ(status(rule, "ffffPP"), ExerciseStatus::exhausted);  // too late
  EXPECT_EQ(status(rule, "ffiVXf"), ExerciseStatus::practised);  // three of them count
  EXPECT_EQ(progress_of(rule, trials("ffPf"), true).sentence,
            "all 4 trials are used up, 0 of 2 passes in a row");
}

TEST(Proficiency, ALockedExerciseIsLockedWhateverWasTried) {
  EXPECT_EQ(status(kTwoInARow, "", false), ExerciseStatus::locked);
  EXPECT_EQ(status(kTwoInARow, "fP", false), ExerciseStatus::locked);
}

TEST(Proficiency, SaysHowFarItIs) {
  EXPECT_EQ(progress_of(kTwoInARow, trials(""), true).sentence, "0 of 2 passes in a row");
  EXPECT_EQ(progress_of(kTwoInARow, trials("fP"), true).sentence, "1 of 2 passes in a row");
  EXPECT_EQ(progress_of(kTwoInARow, trials("fPP"), true).sentence, "proficient after 3 trials");
  EXPECT_EQ(progress_of({.consecutive = 1}, trials("f"), true).sentence, "no pass yet");
}

TEST(Proficiency, ARuleWithoutARowStillAsksForOnePass) {
  EXPECT_EQ(status({.consecutive = 0}, ""), ExerciseStatus::available);
  EXPECT_EQ(status({.consecutive = 0}, "f"), ExerciseStatus::practised);
  EXPECT_EQ(status({.consecutive = 0}, "P"), ExerciseStatus::proficient);
}

}  // namespace
}  // namespace assessment
