// Every drawing: well-formed, described, with its numbers behind it, and inside its frame.
#include <cmath>

#include <gtest/gtest.h>

#include "reports/progress_charts.h"
#include "reports/svg.h"
#include "reports/trial_charts.h"
#include "tests/reports/samples.h"

namespace {

using boost::property_tree::ptree;
using reports::Chart;

// Each mark and the beginning of each text must lie inside the drawing.
void expect_inside(const ptree& svg) {
  const double width = svg.get<double>("<xmlattr>.width");
  const double height = svg.get<double>("<xmlattr>.height");
  for (const auto& [name, element] : svg) {
    for (const char* key : {"x", "x1", "x2", "cx"}) {
      const auto value = element.get_optional<double>(std::string("<xmlattr>.") + key);
      EXPECT_TRUE(!value || (*value >= 0.0 && *value <= width)) << name << " " << key;
    }
    for (const char* key : {"y", "y1", "y2", "cy"}) {
      const auto value = element.get_optional<double>(std::string("<xmlattr>.") + key);
      EXPECT_TRUE(!value || (*value >= 0.0 && *value <= height)) << name << " " << key;
    }
  }
}

void expect_sound(const Chart& chart) {
  SCOPED_TRACE(chart.id);
  const auto tree = samples::parsed(chart.svg);
  ASSERT_TRUE(tree) << chart.svg.substr(0, 300);
  const ptree& svg = tree->get_child("svg");
  EXPECT_FALSE(svg.get<std::string>("title").empty());
  EXPECT_FALSE(svg.get<std::string>("desc").empty());
  EXPECT_EQ(svg.get<std::string>("<xmlattr>.role"), "img");
  EXPECT_EQ(chart.svg.find("nan"), std::string::npos);
  EXPECT_EQ(chart.svg.find(" style="), std::string::npos);
  EXPECT_FALSE(chart.summary.empty());
  for (const auto& row : chart.table.rows) EXPECT_EQ(row.size(), chart.table.columns.size());
  expect_inside(svg);
}

TEST(ComparisonCharts, HoldForOnePersonOrFortyAndOneTrialOrAHundred) {
  for (const int people : {1, 2, 12, 13, 40}) {
    for (const int trials : {1, 2, 10, 100}) {
      const auto comparison = samples::compared(samples::made_up_rows(people, trials));
      const auto charts = reports::comparison_charts(comparison, samples::subject());
      ASSERT_EQ(charts.size(), 5U);
      for (const Chart& chart : charts) expect_sound(chart);
      const auto points = static_cast<std::size_t>(people * trials);
      EXPECT_EQ(charts[0].table.rows.size(), points);
      EXPECT_EQ(charts[1].table.rows.size(), points);
      EXPECT_EQ(charts[2].table.rows.size(), static_cast<std::size_t>(2 * people));
    }
  }
}

TEST(ComparisonCharts, DrawAMarkerForEveryPublishedTrial) {
  const auto comparison = samples::compared(samples::paper_rows("linear"));
  const auto charts = reports::comparison_charts(comparison, samples::subject());
  EXPECT_EQ(samples::occurrences(charts[0].svg, " filled\""), 30);
  EXPECT_EQ(samples::occurrences(charts[1].svg, " hollow\""), 30);
  EXPECT_EQ(charts[0].table.rows[0], (std::vector<std::string>{"No.1", "1", "252"}));
  EXPECT_EQ(charts[3].table.rows.size(), 3U);  // g and both ends of its interval
  EXPECT_EQ(samples::occurrences(charts[4].svg, "<polygon"),
            static_cast<int>(charts[4].table.rows.size()));
}

TEST(ComparisonCharts, HaveTheIdsThatPagesRelyOn) {
  const auto charts = reports::comparison_charts(samples::compared(samples::made_up_rows(2, 2)),
                                                 samples::subject());
  const char* const ids[] = {"experts", "novices", "participant-means", "effect", "p-floor"};
  for (std::size_t i = 0; i < charts.size(); ++i) EXPECT_EQ(charts[i].id, ids[i]);
}

TEST(ComparisonCharts, EscapeHostileNames) {
  const std::string hostile = "<script>\"'&\x02 \u00e9";
  const auto comparison = samples::compared(samples::made_up_rows(2, 3, hostile));
  for (const Chart& chart : reports::comparison_charts(comparison, samples::subject())) {
    expect_sound(chart);
    EXPECT_EQ(chart.svg.find("<script"), std::string::npos);
  }
}

TEST(Svg, ShortensBetweenCharactersAndKeepsWhatFits) {
  EXPECT_EQ(reports::shortened("No.1", 60.0), "No.1");
  EXPECT_EQ(reports::shortened("\u00e9\u00e9\u00e9\u00e9\u00e9\u00e9\u00e9\u00e9", 6.5 * 4.5),
            "\u00e9\u00e9\u00e9\u2026");
  EXPECT_EQ(reports::shortened("abcdefghij", 6.5 * 7.5, false, true), "abc\u2026hij");
}

reports::ProgressChart progress(int trials) {
  reports::ProgressChart chart;
  chart.id = "linear-time";
  chart.title = "Time per trial";
  chart.unit = "s";
  chart.who = "<You>";
  chart.target = 90.0;
  for (int n = 1; n <= trials; ++n) {
    chart.points.push_back({n, 80.0 + 60.0 / n, n > 5, n % 4 != 0});
  }
  return chart;
}

TEST(ProgressChart, HoldsFromNoTrialToHundreds) {
  for (const int trials : {0, 1, 2, 12, 40, 100, 900}) {
    const Chart chart = reports::progress_chart(progress(trials));
    expect_sound(chart);
    EXPECT_EQ(chart.table.rows.size(), static_cast<std::size_t>(trials));
    EXPECT_EQ(samples::occurrences(chart.svg, "<circle"), trials);
  }
}

TEST(ProgressChart, DrawsTargetAndBandWithWords) {
  auto input = progress(12);
  input.expert_low = 70.0;
  input.expert_median = 75.0;
  input.expert_high = 82.0;
  const Chart chart = reports::progress_chart(input);
  EXPECT_NE(chart.svg.find(">Target 90 s<"), std::string::npos);
  EXPECT_NE(chart.svg.find(">Experts, middle half<"), std::string::npos);
}

TEST(ProgressChart, TheSameInputGivesTheSameBytes) {
  EXPECT_EQ(reports::progress_chart(progress(40)).svg, reports::progress_chart(progress(40)).svg);
}

TEST(SmallProgressChart, HoldsFromNoTrialToHundredsOfAnySize) {
  for (const double scale : {0.0, 1e-3, 1.0, 1e4}) {
    for (const int trials : {0, 1, 2, 12, 60, 900}) {
      auto input = progress(trials);
      for (auto& point : input.points) point.value *= scale;
      const Chart chart = reports::small_progress_chart(input);
      expect_sound(chart);
      EXPECT_EQ(samples::occurrences(chart.svg, "<circle"), trials);
      EXPECT_NE(chart.svg.find(">target<"), std::string::npos);
    }
  }
}

TEST(SmallProgressChart, SharesTheAxisOfTrialsWithItsLike) {
  auto input = progress(3);
  input.last_ordinal = 12;  // the later trials were not completed
  EXPECT_NE(reports::small_progress_chart(input).svg.find(">12<"), std::string::npos);
}

TEST(SmallProgressChart, SaysWhenNoTrialWasCompleted) {
  auto input = progress(0);
  input.unfinished = 2;
  EXPECT_NE(reports::small_progress_chart(input).svg.find(">None completed<"), std::string::npos);
  EXPECT_NE(reports::progress_chart(input).svg.find(">No trial completed yet<"), std::string::npos);
}

TEST(StepTimeChart, HoldsForNoStepAndForMany) {
  for (const int steps : {0, 1, 3, 24}) {
    std::vector<reports::StepDuration> durations;
    for (int i = 0; i < steps; ++i) {
      durations.push_back(
          {"Turn <clockwise> & hold still for a good while " + std::to_string(i), 1.5 * i});
    }
    const Chart chart = reports::step_time_chart(durations);
    expect_sound(chart);
    EXPECT_EQ(chart.table.rows.size(), static_cast<std::size_t>(steps));
  }
}

// Quiet but for one sample in the middle.
assessment::RecordedTrial trial_with_peak(double seconds, double peak) {
  assessment::RecordedTrial trial;
  trial.end_time = seconds;
  const int count = static_cast<int>(seconds * assessment::kSampleRate);
  for (int i = 0; i < count; ++i) {
    assessment::Sample sample;
    sample.time = i / assessment::kSampleRate;
    sample.contact_force_peak = i == count / 2 ? peak : 0.1;
    trial.samples.push_back(sample);
  }
  trial.events.push_back({seconds / 2.0, "wall_hit", assessment::Severity::info, "", 0.0});
  return trial;
}

TEST(ContactForceChart, KeepsThePeakOfATrialHoweverLong) {
  for (const double seconds : {2.0, 60.0, 4000.0}) {
    const Chart chart = reports::contact_force_chart(trial_with_peak(seconds, 2.5), 2.0);
    expect_sound(chart);
    EXPECT_NE(chart.summary.find("Highest contact force 2.50 N, training limit 2 N; 1 wall hit"),
              std::string::npos)
        << chart.summary;
    ASSERT_EQ(chart.table.rows.size(), 1U);
    EXPECT_EQ(chart.table.rows[0][2], "2.50");
    const auto tree = samples::parsed(chart.svg);
    // the drawn curve climbs above the limit line
    std::istringstream points(tree->get<std::string>("svg.polyline.<xmlattr>.points"));
    double highest = 1e9, limit = 0.0, x = 0.0, y = 0.0;
    char comma = 0;
    while (points >> x >> comma >> y) highest = std::min(highest, y);
    for (const auto& [name, element] : tree->get_child("svg")) {
      if (element.get<std::string>("<xmlattr>.class", "") == "limit") {
        limit = element.get<double>("<xmlattr>.y1");
      }
    }
    EXPECT_LT(highest, limit);
  }
}

TEST(ContactForceChart, NeverRoundsOntoTheLimit) {
  const Chart chart = reports::contact_force_chart(trial_with_peak(10.0, 2.0004), 2.0);
  EXPECT_NE(chart.summary.find("2.0004 N"), std::string::npos) << chart.summary;
}

TEST(ContactForceChart, HoldsForAnEmptyTrial) {
  expect_sound(reports::contact_force_chart({}, std::nullopt));
  expect_sound(reports::contact_force_chart({}, 2.0));
}

}  // namespace
