#include "assessment/statistics/power_law.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace assessment {
namespace {

const std::vector<double> kTen{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};

std::vector<double> law(double a, double b) {
  std::vector<double> values;
  for (const double n : kTen) values.push_back(a * std::pow(n, -b));
  return values;
}

TEST(PowerLaw, RecoversTheLawThatMadeTheValues) {
  for (const double b : {-0.4, 0.02, 0.3, 1.7, 4.2}) {
    for (const auto scale : {PowerLawScale::raw, PowerLawScale::log_log}) {
      const auto fit = fit_power_law(kTen, law(420.0, b), scale);
      ASSERT_TRUE(fit);
      // the values round at 1e-16, the root of the slope is found to 1e-14
      EXPECT_NEAR(fit->b, b, 1e-9);
      EXPECT_NEAR(fit->a, 420.0, 1e-6);
      EXPECT_NEAR(fit->learning_rate, std::pow(2.0, -b), 1e-9);
      EXPECT_NEAR(fit->value_at(4.0), 420.0 * std::pow(4.0, -b), 1e-6);
      EXPECT_NEAR(*fit->r_squared, 1.0, 1e-9);
    }
  }
}

TEST(PowerLaw, DoesNotDependOnTheUnitOfTheValues) {
  std::vector<double> values{30, 25, 26, 21, 22, 19, 20, 18, 19, 17}, large;
  for (const double v : values) large.push_back(v * 1e140);
  const auto plain = fit_power_law(kTen, values), scaled = fit_power_law(kTen, large);
  ASSERT_TRUE(plain && scaled);
  EXPECT_NEAR(plain->b, scaled->b, 1e-12);
  EXPECT_NEAR(plain->a, scaled->a / 1e140, 1e-9);
}

TEST(PowerLaw, TakesGapsInTheOrdinals) {
  const std::vector<double> trials{1, 4, 9, 20};
  std::vector<double> values;
  for (const double n : trials) values.push_back(50.0 * std::pow(n, -0.5));
  EXPECT_NEAR(fit_power_law(trials, values)->b, 0.5, 1e-9);
}

TEST(PowerLaw, AConstantSeriesHasNoSlopeAndNoShareExplained) {
  const auto fit = fit_power_law(kTen, std::vector<double>(10, 7.0));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->b, 0.0, 1e-12);
  EXPECT_NEAR(fit->a, 7.0, 1e-12);
  EXPECT_FALSE(fit->r_squared);
  EXPECT_FALSE(fit->b_interval);
}

TEST(PowerLaw, SaysWhenAParameterIsAtItsBoundOrNotIdentified) {
  // one error at first and none after: any steep enough law fits
  const auto steep = fit_power_law(kTen, std::vector<double>{3, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  ASSERT_TRUE(steep);
  EXPECT_TRUE(steep->at_bound);
  EXPECT_FALSE(steep->b_interval);
  const auto nothing = fit_power_law(kTen, std::vector<double>(10, 0.0));
  ASSERT_TRUE(nothing);
  EXPECT_TRUE(nothing->not_identified);
}

TEST(PowerLaw, AnOpenIntervalIsLeftOut) {
  // three scattered values leave one degree of freedom: F(.95; 1, 1) is 161
  const auto fit = fit_power_law(std::vector<double>{1, 2, 3}, std::vector<double>{10, 7, 9});
  ASSERT_TRUE(fit);
  EXPECT_FALSE(fit->b_interval);
}

}  // namespace
}  // namespace assessment
