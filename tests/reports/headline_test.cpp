#include <gtest/gtest.h>

#include "reports/progress_charts.h"
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

}  // namespace
