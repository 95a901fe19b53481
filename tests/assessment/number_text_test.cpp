#include "assessment/number_text.h"

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace assessment {
namespace {

TEST(NumberText, IsShortWhereNothingHangsOnIt) {
  EXPECT_EQ(exact_text(90.0), "90");
  EXPECT_EQ(exact_text(0.1), "0.1");
  EXPECT_EQ(rounded_text(112.4321, "s"), "112.4");
  EXPECT_EQ(rounded_text(2.31456, "N"), "2.31");
  EXPECT_EQ(rounded_text(0.931, ""), "0.93");
  EXPECT_EQ(rounded_text(7.0, ""), "7");
  EXPECT_EQ(rounded_text(-0.001, "N"), "0");
  EXPECT_EQ(text_beside(112.4321, 90.0, "s"), "112.4");
  EXPECT_EQ(distance_text(112.4321, 90.0, "s"), "22.4");
  EXPECT_EQ(distance_text(112.44, 90.05, "s"), "22.35");
}

TEST(NumberText, NeverRoundsAcrossTheBound) {
  EXPECT_EQ(text_beside(90.0004, 90.0, "s"), "90.0004");
  EXPECT_EQ(distance_text(90.0004, 90.0, "s"), "0.0004");
  EXPECT_EQ(text_beside(89.96, 90.0, "s"), "89.96");
  EXPECT_EQ(text_beside(90.0, 90.0, "s"), "90");
  EXPECT_EQ(text_beside(std::nextafter(2.0, 3.0), 2.0, "N"), "2.0000000000000004");

  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> mantissa(0.5, 200.0);
  for (int round = 0; round < 20000; ++round) {
    const double bound = std::round(mantissa(random) * 10.0) / 10.0;
    const double value =
        bound + std::ldexp(mantissa(random) - 100.0, -static_cast<int>(random() % 60));
    const double shown = std::strtod(text_beside(value, bound, "s").c_str(), nullptr);
    ASSERT_EQ(shown > bound, value > bound) << value << " beside " << bound;
    ASSERT_EQ(shown < bound, value < bound) << value << " beside " << bound;
    const double distance = std::strtod(distance_text(value, bound, "s").c_str(), nullptr);
    ASSERT_EQ(distance == 0.0, value == bound) << value << " beside " << bound;
  }
}

TEST(NumberText, HugeNumbersStillFit) {
  EXPECT_EQ(std::strtod(rounded_text(1.7e308, "s").c_str(), nullptr), 1.7e308);
  EXPECT_FALSE(distance_text(1.7e308, -1.7e308, "s").empty());
}

}  // namespace
}  // namespace assessment
