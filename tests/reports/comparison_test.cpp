// The comparison as page and as CSV: the paper's figures, hostile names, determinism.
#include <gtest/gtest.h>

#include "tests/reports/samples.h"

namespace {

using assessment::GroupComparison;

// The value column of the CSV line that begins so.
double value_of(const std::string& csv, const std::string& start) {
  const auto at = csv.find("\n" + start + ",");
  if (at == std::string::npos) return -1e300;
  return std::stod(csv.substr(at + start.size() + 2));
}

TEST(ComparisonCsv, HoldsThePublishedFigures) {
  const auto comparison = samples::compared(samples::paper_rows("linear"));
  const std::string csv = reports::comparison_csv(comparison, samples::subject());
  // 7120 s in 30 expert trials, 11724 s in 30 novice trials
  EXPECT_NEAR(value_of(csv, "group,expert,mean"), 7120.0 / 30.0, 1e-9);
  EXPECT_NEAR(value_of(csv, "group,novice,mean"), 11724.0 / 30.0, 1e-9);
  EXPECT_EQ(value_of(csv, "test,participants,mann_whitney_u"), 0.0);
  EXPECT_NEAR(value_of(csv, "test,participants,p_exact_two_sided"), 0.1, 1e-12);
  EXPECT_NEAR(value_of(csv, "test,participants,p_floor"), 0.1, 1e-12);
  // published to four decimals
  EXPECT_NEAR(value_of(csv, "effect,participants,hedges_g"), -6.2222, 5e-5);
  EXPECT_NEAR(value_of(csv, "effect,participants,hedges_g_low"), -10.5493, 5e-5);
  EXPECT_NEAR(value_of(csv, "effect,participants,hedges_g_high"), -1.9258, 5e-5);
}

TEST(ComparisonCsv, HasOneLinePerTrial) {
  const auto comparison = samples::compared(samples::paper_rows("rotational"));
  const std::string csv = reports::comparison_csv(comparison, samples::subject());
  EXPECT_EQ(samples::occurrences(csv, "\ntrial,"), 60);
}

TEST(ComparisonCsv, GuardsNamesThatAreFormulas) {
  const auto comparison = samples::compared(samples::made_up_rows(2, 3, "=HYPERLINK(1)"));
  const std::string csv = reports::comparison_csv(comparison, samples::subject());
  EXPECT_EQ(csv.find(",=HYPERLINK"), std::string::npos);
  EXPECT_NE(csv.find(",'=HYPERLINK"), std::string::npos);
}

TEST(ComparisonPage, ShowsThePublishedFigures) {
  const auto comparison = samples::compared(samples::paper_rows("linear"));
  const std::string html = reports::comparison_html(comparison, samples::subject());
  for (const char* words : {"237.33", "390.80", "\u22126.22", "\u221210.55", "\u22121.93",
                            "p = 0.10", "U = 0", "No.6 (novice)", "ab12"}) {
    EXPECT_NE(html.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(samples::occurrences(html, "<svg "), 5);
}

TEST(ComparisonPage, NeedsNoNetworkAndNoScript) {
  const auto comparison = samples::compared(samples::paper_rows("linear"));
  const std::string html = reports::comparison_html(comparison, samples::subject());
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find("<link"), std::string::npos);
  EXPECT_EQ(html.find(" src="), std::string::npos);
  EXPECT_EQ(samples::occurrences(html, "http://"),
            samples::occurrences(html, "http://www.w3.org/2000/svg"));
}

TEST(ComparisonPage, EscapesHostileNamesEverywhere) {
  const std::string hostile = "<script>alert('x')</script>\"&\x01";
  auto subject = samples::subject();
  subject.exercise_title = subject.dataset_title = subject.apparatus = hostile;
  const auto comparison = samples::compared(samples::made_up_rows(3, 4, hostile));
  const std::string html = reports::comparison_html(comparison, subject);
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_NE(html.find("&lt;script&gt;"), std::string::npos);
}

TEST(ComparisonPage, SplitsTheTableOfManyPeople) {
  const auto comparison = samples::compared(samples::made_up_rows(13, 2));
  const std::string html = reports::comparison_html(comparison, samples::subject());
  EXPECT_NE(html.find("Every trial, people 1 to 10 of 26"), std::string::npos);
  EXPECT_NE(html.find("Every trial, people 21 to 26 of 26"), std::string::npos);
  EXPECT_NE(html.find("Pn13 (novice)"), std::string::npos);
}

TEST(Comparison, TheSameInputGivesTheSameBytes) {
  const auto rows = samples::made_up_rows(14, 20);
  const auto once = samples::compared(rows);
  const auto again = samples::compared(rows);
  EXPECT_EQ(reports::comparison_html(once, samples::subject()),
            reports::comparison_html(again, samples::subject()));
  EXPECT_EQ(reports::comparison_csv(once, samples::subject()),
            reports::comparison_csv(again, samples::subject()));
}

TEST(ComparisonTables, PrintTheTrialsAsThePaperDoes) {
  const auto table = reports::trials_table(samples::compared(samples::paper_rows("linear")));
  ASSERT_EQ(table.rows.size(), 10U);
  EXPECT_EQ(table.rows[0],
            (std::vector<std::string>{"1", "252", "291", "241", "402", "433", "399"}));
  EXPECT_EQ(table.rows[9],
            (std::vector<std::string>{"10", "211", "259", "204", "373", "379", "349"}));
}

TEST(ComparisonTables, HaveARowForEveryoneAndForBothGroups) {
  const auto table = reports::learning_table(samples::compared(samples::made_up_rows(1, 1)));
  ASSERT_EQ(table.rows.size(), 4U);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
}

}  // namespace
