#include "reports/instrument_charts.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace reports {
namespace {

constexpr double kQuarterPi = std::numbers::pi / 4.0;

TEST(TipLine, AnArcOf45DegreesOver20MillimetresEndsWhereItsCircleDoes) {
  const std::vector<Point> line = tip_line({{0.0, 20.0, kQuarterPi}}, 20.0);
  const double radius = 20.0 / kQuarterPi;  // mm
  EXPECT_DOUBLE_EQ(line.front().x, 0.0);
  EXPECT_NEAR(line.back().x, radius * std::sin(kQuarterPi), 1e-9);
  EXPECT_NEAR(line.back().y, radius * (1.0 - std::cos(kQuarterPi)), 1e-9);
}

TEST(TipLine, AStraightPartBehindTheBendMovesItAlong) {
  const std::vector<Point> line = tip_line({{0.0, 20.0, kQuarterPi}}, 50.0);
  const double radius = 20.0 / kQuarterPi;
  EXPECT_NEAR(line.back().x, 30.0 + radius * std::sin(kQuarterPi), 1e-9);
  EXPECT_NEAR(line.back().y, radius * (1.0 - std::cos(kQuarterPi)), 1e-9);
}

TEST(TipLine, WithoutABendIsStraight) {
  const std::vector<Point> line = tip_line({}, 30.0);
  EXPECT_NEAR(line.back().x, 30.0, 1e-9);
  EXPECT_DOUBLE_EQ(line.back().y, 0.0);
}

TEST(TipChart, SaysTheAngleAndCarriesAScale) {
  const Chart chart = tip_chart("tip", "Wire", {{0.0, 20.0, kQuarterPi}}, 0.9);
  EXPECT_NE(chart.summary.find("45 degrees"), std::string::npos) << chart.summary;
  EXPECT_NE(chart.svg.find("10 mm"), std::string::npos);
  ASSERT_EQ(chart.table.rows.size(), 1u);
  EXPECT_EQ(chart.table.rows[0][2], "45.0");
}

TEST(StiffnessChart, TellsTheTwoLinesApartWithoutColourAndListsItsNumbers) {
  const Chart chart = stiffness_chart("ei", "Wire", {{50.0, 10.0, 8.0}, {1450.0, 400.0, 310.0}});
  EXPECT_NE(chart.svg.find("stroke-dasharray"), std::string::npos);
  EXPECT_NE(chart.svg.find("GJ, twist (dashed)"), std::string::npos);
  ASSERT_EQ(chart.table.rows.size(), 2u);
  EXPECT_EQ(chart.table.rows[1][0], "50.0");
  EXPECT_NE(chart.summary.find("N mm²"), std::string::npos);
}

}  // namespace
}  // namespace reports
