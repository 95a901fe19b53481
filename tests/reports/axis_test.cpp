#include "reports/axis.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

struct Span {
  double low, high;
};
const Span kSpans[] = {{199, 433},   {0, 1},         {0.0495, 0.056}, {-15, 0},    {-0.3, 12.7},
                       {1e-6, 3e-6}, {0, 123456789}, {80, 80},        {99.9, 100}, {-1e-3, 1e-3}};

TEST(Axis, TicksCoverTheRange) {
  for (const Span& span : kSpans) {
    const auto ticks = reports::round_ticks(span.low, span.high, 5);
    ASSERT_GE(ticks.size(), 2U);
    const double slack = 1e-6 * (ticks[1] - ticks[0]);
    EXPECT_LE(ticks.front(), span.low + slack);
    EXPECT_GE(ticks.back(), span.high - slack);
    EXPECT_LE(ticks.size(), 9U) << span.low << " to " << span.high;
  }
}

TEST(Axis, TicksAreEvenMultiplesOfARoundStep) {
  for (const Span& span : kSpans) {
    const auto ticks = reports::round_ticks(span.low, span.high, 5);
    const double step = ticks[1] - ticks[0];
    double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
    EXPECT_TRUE(std::abs(mantissa - 1.0) < 1e-6 || std::abs(mantissa - 2.0) < 1e-6 ||
                std::abs(mantissa - 2.5) < 1e-6 || std::abs(mantissa - 5.0) < 1e-6)
        << step;
    for (const double tick : ticks) {
      EXPECT_NEAR(tick / step, std::round(tick / step), 1e-6);
    }
  }
}

TEST(Axis, LabelsShareTheDecimalsOfTheFinestTick) {
  EXPECT_EQ(reports::tick_texts({0.0, 2.5, 5.0}), (std::vector<std::string>{"0.0", "2.5", "5.0"}));
  EXPECT_EQ(reports::tick_texts({-4.0, 0.0}), (std::vector<std::string>{"\u22124", "0"}));
}

TEST(Axis, NeighbouringLabelsNeverReadTheSame) {
  for (const Span& span : kSpans) {
    const auto words = reports::tick_texts(reports::round_ticks(span.low, span.high, 5));
    for (std::size_t i = 1; i < words.size(); ++i) {
      EXPECT_NE(words[i], words[i - 1]) << span.low << " to " << span.high;
    }
  }
}

}  // namespace
