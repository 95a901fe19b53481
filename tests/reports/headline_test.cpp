#include <gtest/gtest.h>

#include "reports/progress_charts.h"
#include "reports/standing.h"
#include "tests/reports/samples.h"

namespace {

using Rows = std::vector<assessment::TrialValue>;

bool begins(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

TEST(ComparisonHeadline, SaysWhoWasFasterByHowMuchAndHowSure) {
  EXPECT_EQ(reports::comparison_headline(samples::compared(samples::paper_rows("linear"))),
            "Experts were faster: 237.3 s against 390.8 s on average, 153.5 s less (95 % Welch "
            "interval 103.6 to 203.3 s). Every expert's mean lies below every novice's.");
}

TEST(ComparisonHeadline, SaysSlowerWhenExpertsWere) {
  const Rows rows = {{"expert", "a", 1, 30.0}, {"novice", "b", 1, 20.0}};
  EXPECT_EQ(reports::comparison_headline(samples::compared(rows)),
            "Experts were slower: 30.0 s against 20.0 s on average, 10.0 s more. Every expert's "
            "mean lies above every novice's.");
}

TEST(ComparisonHeadline, FollowsTheDirectionOfAnotherMetric) {
  assessment::ComparisonQuestion question;
  question.unit = "points";
  question.direction = assessment::Direction::higher_is_better;
  const Rows rows = {{"expert", "a", 1, 30.0}, {"novice", "b", 1, 20.0}};
  EXPECT_TRUE(begins(reports::comparison_headline(samples::compared(rows, question)),
                     "Experts were better: 30.0 points against 20.0 points"));
  question.direction = assessment::Direction::lower_is_better;
  EXPECT_TRUE(begins(reports::comparison_headline(samples::compared(rows, question)),
                     "Experts were worse: "));
}

TEST(ComparisonHeadline, EqualMeansAreNotCalledADifference) {
  const Rows rows = {{"expert", "a", 1, 10.0},
                     {"expert", "b", 1, 30.0},
                     {"novice", "c", 1, 15.0},
                     {"novice", "d", 1, 25.0}};
  const std::string text = reports::comparison_headline(samples::compared(rows));
  EXPECT_TRUE(begins(text, "Experts and novices did not differ: 20.0 s each on average"));
  EXPECT_NE(text.find("which includes no difference"), std::string::npos);
}

reports::ProgressChart progress(const std::vector<double>& values) {
  reports::ProgressChart chart;
  chart.id = "linear-time";
  chart.title = "Time per trial";
  chart.unit = "s";
  chart.who = "You";
  chart.target = 90.0;
  chart.target_provisional = true;
  for (const double value : values) {
    chart.points.push_back({static_cast<int>(chart.points.size()) + 1, value, false, true});
  }
  return chart;
}

TEST(ProgressHeadline, NamesTheLastThreeTheTargetTheChangeAndTheState) {
  EXPECT_EQ(reports::progress_headline("Linear", progress({100.0, 98.0, 91.0, 80.0}),
                                       "not yet proficient (1 of 2 in a row)", true),
            "Linear: last three trials 98, 91, 80 s; target 90 s (provisional); 20 % faster than "
            "your first; not yet proficient (1 of 2 in a row).");
}

TEST(ProgressHeadline, SaysSlowerAndTheSame) {
  EXPECT_NE(reports::progress_headline("L", progress({100.0, 110.0}), "x", false)
                .find("10 % slower than the first"),
            std::string::npos);
  EXPECT_NE(reports::progress_headline("L", progress({100.0, 100.0}), "x", true)
                .find("as fast as your first"),
            std::string::npos);
}

TEST(ProgressHeadline, NeverRoundsAcrossTheTarget) {
  const std::string text = reports::progress_headline("L", progress({90.0004}), "x", true);
  EXPECT_NE(text.find("last trial 90.0004 s"), std::string::npos) << text;
}

TEST(ProgressHeadline, WithoutTrialsSaysSo) {
  EXPECT_EQ(reports::progress_headline("Linear", progress({}), "x", true), "Linear: no trial yet.");
}

TEST(ProgressHeadline, TrialsThatWereNotCompletedAreNotNoTrial) {
  reports::ProgressChart chart = progress({});
  chart.unfinished = 2;
  EXPECT_EQ(reports::progress_headline("Linear", chart, "0 of 2 passes in a row", true),
            "Linear: 2 trials, none completed; 0 of 2 passes in a row.");
}

TEST(ProgressHeadline, LeavesOutWhatDoesNotCount) {
  reports::ProgressChart chart = progress({100.0, 50.0, 80.0});
  chart.points[1].counted = false;
  EXPECT_NE(reports::progress_headline("L", chart, "x", true)
                .find("last two trials 100, 80 s; target 90 s (provisional); 20 % faster"),
            std::string::npos);
  for (reports::TrialPoint& point : chart.points) point.counted = false;
  EXPECT_EQ(reports::progress_headline("L", chart, "x", true),
            "L: 3 trials, none of them counts; x.");
}

TEST(Standing, IsOfTheTrialsThatCount) {
  reports::ProgressChart chart = progress({100.0, 90.0, 60.0, 75.0});
  chart.points[2].counted = false;  // voided: neither previous nor best
  const reports::Standing standing = reports::standing_of(chart);
  EXPECT_EQ(standing.last, 75.0);
  EXPECT_EQ(standing.previous, 90.0);
  EXPECT_EQ(standing.best, 75.0);
  EXPECT_NEAR(*standing.change_to_previous_percent, -100.0 / 6.0, 1e-12);
  EXPECT_EQ(standing.change_to_first_percent, -25.0);
}

TEST(Standing, TheBestFollowsTheDirection) {
  reports::ProgressChart chart = progress({0.5, 0.9, 0.7});
  chart.direction = assessment::Direction::higher_is_better;
  EXPECT_EQ(reports::standing_of(chart).best, 0.9);
}

TEST(Standing, FromZeroThereIsNoPercentage) {
  const reports::Standing standing = reports::standing_of(progress({0.0, 2.0}));
  EXPECT_EQ(standing.previous, 0.0);
  EXPECT_FALSE(standing.change_to_previous_percent);
  EXPECT_FALSE(reports::standing_of(progress({})).last);
  EXPECT_FALSE(reports::standing_of(progress({3.0})).previous);
}

TEST(Standing, SaysInWordsWhichWayIsBetter) {
  using assessment::Direction;
  EXPECT_EQ(reports::change_words(-20.4, Direction::lower_is_better), "20 % lower, better");
  EXPECT_EQ(reports::change_words(-20.4, Direction::higher_is_better), "20 % lower, worse");
  EXPECT_EQ(reports::change_words(0.3, Direction::higher_is_better), "the same");
}

}  // namespace
