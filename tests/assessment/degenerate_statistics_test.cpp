// Constant series, two values, ties, nothing at all, NaN: an answer or a reason, never an infinity.
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/effect_size.h"
#include "assessment/statistics/mean_difference.h"
#include "assessment/statistics/power_law.h"
#include "assessment/statistics/rank_test.h"
#include "assessment/statistics/step_change.h"

namespace assessment {
namespace {

using Series = std::vector<double>;
using base::ErrorCode;

const Series kNone, kOne{5.0}, kTwo{5.0, 6.0}, kConstant{0.1, 0.1, 0.1}, kPlain{1.0, 2.0, 4.0};
const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

TEST(DegenerateStatistics, NaNAndInfinityAreRefusedEverywhere) {
  for (const double bad : {kNan, kInfinity, -kInfinity, 1e200}) {
    const Series broken{1.0, bad, 2.0, 3.0};
    EXPECT_EQ(summarise(broken).error().code, ErrorCode::invalid_input);
    EXPECT_EQ(rank_test(broken, kPlain).error().code, ErrorCode::invalid_input);
    EXPECT_EQ(rank_test(kPlain, broken).error().code, ErrorCode::invalid_input);
    EXPECT_EQ(hedges_g(broken, kPlain).error().code, ErrorCode::invalid_input);
    EXPECT_EQ(dominance(kPlain, broken).error().code, ErrorCode::invalid_input);
    EXPECT_EQ(welch(broken, kPlain).error().code, ErrorCode::invalid_input);
    EXPECT_EQ(find_step_change(broken).error().code, ErrorCode::invalid_input);
    const Series trials{1, 2, 3, 4};
    EXPECT_EQ(fit_power_law(trials, broken).error().code, ErrorCode::invalid_input);
    EXPECT_EQ(fit_power_law(broken, trials).error().code, ErrorCode::invalid_input);
  }
}

TEST(DegenerateStatistics, TooFewValuesAreAnErrorWithAReason) {
  EXPECT_EQ(summarise(kNone).error().code, ErrorCode::not_enough_data);
  EXPECT_EQ(rank_test(kNone, kPlain).error().code, ErrorCode::not_enough_data);
  EXPECT_EQ(dominance(kPlain, kNone).error().code, ErrorCode::not_enough_data);
  EXPECT_EQ(hedges_g(kNone, kPlain).error().code, ErrorCode::not_enough_data);
  EXPECT_EQ(hedges_g(kOne, kTwo).error().code, ErrorCode::not_enough_data);
  EXPECT_EQ(welch(kOne, kPlain).error().code, ErrorCode::not_enough_data);
  EXPECT_EQ(find_step_change(kPlain).error().code, ErrorCode::not_enough_data);
  EXPECT_EQ(fit_power_law(kTwo, kTwo).error().code, ErrorCode::not_enough_data);
  EXPECT_EQ(fit_power_law(Series{2, 2, 2}, kPlain).error().code, ErrorCode::not_enough_data);
  EXPECT_FALSE(fit_power_law(kNone, kNone).error().message.empty());
}

TEST(DegenerateStatistics, WrongInputIsNamed) {
  EXPECT_EQ(fit_power_law(kPlain, kTwo).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(fit_power_law(Series{0, 1, 2}, kPlain).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(fit_power_law(Series{1, 2, 3}, Series{1, 0, 2}, PowerLawScale::log_log).error().code,
            ErrorCode::invalid_input);
  EXPECT_EQ(welch(kPlain, kPlain, 1.0).error().code, ErrorCode::invalid_input);
}

TEST(DegenerateStatistics, GroupsWithoutScatterHaveNoStandardisedDifference) {
  const Series other{0.3, 0.3, 0.3};  // means that round: 0.1 * 3 / 3 is not 0.1
  EXPECT_EQ(hedges_g(kConstant, other).error().code, ErrorCode::not_enough_data);
  EXPECT_EQ(welch(kConstant, other).error().code, ErrorCode::not_enough_data);
  EXPECT_EQ(hedges_g(Series{0, 0}, Series{0, 0}).error().code, ErrorCode::not_enough_data);
}

TEST(DegenerateStatistics, OneValueHasAMeanButNoDeviation) {
  const auto summary = summarise(kOne);
  EXPECT_EQ(summary->mean, 5.0);
  EXPECT_FALSE(summary->standard_deviation);
  EXPECT_EQ(summary->quartile_low, 5.0);
}

TEST(DegenerateStatistics, TheSmallestGroupsThatAllowAnEffectGiveFiniteOnes) {
  const auto two_each = hedges_g(Series{1, 2}, Series{4, 6});
  ASSERT_TRUE(two_each);
  EXPECT_TRUE(std::isfinite(two_each->g));
  ASSERT_TRUE(two_each->interval);
  EXPECT_LT(two_each->interval->low, two_each->g);
  EXPECT_GT(two_each->interval->high, two_each->g);
  EXPECT_TRUE(hedges_g(kOne, kPlain));
  const auto one_constant = welch(Series{2, 2}, Series{4, 6});
  ASSERT_TRUE(one_constant);
  EXPECT_NEAR(one_constant->degrees_of_freedom, 1.0, 1e-12);
}

TEST(DegenerateStatistics, AnEnormousEffectHasNoIntervalRatherThanAWrongOne) {
  const auto effect = hedges_g(Series{0, 1e-6, 2e-6}, Series{100, 100.000001, 100.000002});
  ASSERT_TRUE(effect);
  EXPECT_TRUE(std::isfinite(effect->g));
  EXPECT_FALSE(effect->interval);
}

TEST(DegenerateStatistics, IntervalsOfGBracketItOverAWideRange) {
  for (const double shift : {0.0, 0.1, 1.0, 5.0, 20.0, 60.0, 200.0}) {
    for (const int n : {2, 3, 10, 100}) {
      Series first, second;
      for (int i = 0; i < n; ++i) first.push_back(i % 2), second.push_back(i % 2 + shift);
      const auto effect = hedges_g(first, second);
      ASSERT_TRUE(effect);
      if (!effect->interval) continue;
      EXPECT_LT(effect->interval->low, effect->g) << shift << " " << n;
      EXPECT_GT(effect->interval->high, effect->g) << shift << " " << n;
    }
  }
}

}  // namespace
}  // namespace assessment
