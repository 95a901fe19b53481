#include "reports/number.h"

#include <cstdlib>

#include <gtest/gtest.h>

namespace {

TEST(Number, NegativeValuesCarryATrueMinusSign) {
  EXPECT_EQ(reports::fixed(-6.2222, 2), "\u22126.22");
  EXPECT_EQ(reports::fixed(6.2222, 2), "6.22");
}

TEST(Number, WhatRoundsToZeroHasNoSign) { EXPECT_EQ(reports::fixed(-0.004, 2), "0.00"); }

TEST(Number, PlainKeepsAboutThreeDigits) {
  EXPECT_EQ(reports::plain(1234.5), "1234");
  EXPECT_EQ(reports::plain(237.333), "237.3");
  EXPECT_EQ(reports::plain(12.44), "12.4");
  EXPECT_EQ(reports::plain(0.857), "0.86");
  EXPECT_EQ(reports::plain(0.0834), "0.083");
  EXPECT_EQ(reports::plain(0.0), "0");
}

TEST(Number, ExactReadsBackAsTheSameNumber) {
  for (const double value : {0.1, 1.0 / 3.0, -6.222222222, 237.0, 1e-12}) {
    EXPECT_EQ(std::strtod(reports::exact(value).c_str(), nullptr), value);
  }
}

TEST(Number, AColumnHasTheDecimalsOfItsFinestNumber) {
  EXPECT_EQ(reports::common_decimals({252.0, 231.0}), 0);
  EXPECT_EQ(reports::common_decimals({0.0, 2.5, 5.0}), 1);
  EXPECT_EQ(reports::common_decimals({0.0, 0.025}), 3);
  EXPECT_EQ(reports::common_decimals({1.0 / 3.0}, 3), 3);
}

TEST(Number, PHasTwoDigitsAndIsNeverZero) {
  EXPECT_EQ(reports::p_text(0.1), "0.10");
  EXPECT_EQ(reports::p_text(1.0), "1.00");
  EXPECT_EQ(reports::p_text(0.0286), "0.029");
  EXPECT_EQ(reports::p_text(0.0), "< 0.0001");
  EXPECT_EQ(reports::p_statement(0.1), "p = 0.10");
  EXPECT_EQ(reports::p_statement(1e-9), "p < 0.0001");
}

TEST(Number, PIsNotRoundedOntoTheOtherSideOfFivePercent) {
  EXPECT_EQ(reports::p_text(0.05), "0.05");
  EXPECT_EQ(reports::p_text(0.0496), "0.0496");
  EXPECT_EQ(reports::p_text(0.0504), "0.0504");
}

TEST(Number, TheTiniestValuesAreWrittenWithAPowerOfTen) {
  EXPECT_EQ(reports::small_text(7.4e-7), "7.4 \u00d7 10\u207b\u2077");
  EXPECT_EQ(reports::small_text(9.99e-7), "1.0 \u00d7 10\u207b\u2076");
  EXPECT_EQ(reports::small_text(0.1), "0.10");
  EXPECT_EQ(reports::power_of_ten_text(-12), "10\u207b\u00b9\u00b2");
  EXPECT_EQ(reports::power_of_ten_text(-3), "0.001");
}

}  // namespace
