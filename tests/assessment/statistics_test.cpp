// Every statistic against the reference values of the published linear task: R 4.2.2 and
// SciPy 1.10.1, to the tolerances stated in the file of reference values.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/effect_size.h"
#include "assessment/statistics/mean_difference.h"
#include "assessment/statistics/power_law.h"
#include "assessment/statistics/rank_test.h"
#include "assessment/statistics/step_change.h"
#include "tests/assessment/oracle.h"

namespace assessment {
namespace {

constexpr double kDefault = 1e-6, kNonlinear = 1e-5, kNonCentral = 1e-5;

// name in the reference file -> the series it describes
std::map<std::string, std::vector<double>> reference_series() {
  std::map<std::string, std::vector<double>> series;
  for (const auto& [participant, seconds] : oracle::linear_seconds()) {
    series["linear.No" + participant.substr(3)] = seconds;
  }
  for (const std::string group : {"expert", "novice"}) {
    const int first = group == "expert" ? 1 : 4;
    std::vector<double> mean(10, 0.0);
    for (int k = first; k < first + 3; ++k) {
      for (std::size_t i = 0; i < 10; ++i) {
        mean[i] += series["linear.No" + std::to_string(k)][i] / 3.0;
      }
    }
    series["linear." + group + ".groupmean"] = mean;
  }
  return series;
}

std::vector<double> ordinals(std::size_t count) {
  std::vector<double> trials;
  for (std::size_t i = 1; i <= count; ++i) trials.push_back(static_cast<double>(i));
  return trials;
}

TEST(Descriptive, AgreesWithRForEveryParticipant) {
  for (const auto& [participant, seconds] : oracle::linear_seconds()) {
    const std::string key = "linear.No" + participant.substr(3) + ".";
    const auto summary = summarise(seconds);
    ASSERT_TRUE(summary);
    oracle::expect_close(summary->mean, oracle::value(key + "mean"), kDefault, key);
    oracle::expect_close(*summary->standard_deviation, oracle::value(key + "sd"), kDefault, key);
    oracle::expect_close(summary->median, oracle::value(key + "median"), kDefault, key);
    const auto quartiles = oracle::values(key + "quartiles_type7");
    oracle::expect_close(summary->quartile_low, quartiles[0], kDefault, key);
    oracle::expect_close(summary->quartile_high, quartiles[1], kDefault, key);
    EXPECT_EQ(summary->minimum, oracle::value(key + "min"));
    EXPECT_EQ(summary->maximum, oracle::value(key + "max"));
  }
}

TEST(PowerLaw, RawFitAgreesWithNonlinearLeastSquaresInR) {
  for (const auto& [name, seconds] : reference_series()) {
    const auto fit = fit_power_law(ordinals(seconds.size()), seconds);
    ASSERT_TRUE(fit) << name;
    const std::string key = name + ".power2.";
    oracle::expect_close(fit->a, oracle::value(key + "a"), kNonlinear, key);
    oracle::expect_close(fit->b, oracle::value(key + "b"), kNonlinear, key);
    oracle::expect_close(*fit->r_squared, oracle::value(key + "r2"), kDefault, key);
    oracle::expect_close(fit->residual_deviation, oracle::value(key + "rmse"), kDefault, key);
    const auto interval = oracle::values(key + "b_ci95_profile");
    ASSERT_TRUE(fit->b_interval) << name;
    oracle::expect_close(fit->b_interval->low, interval[0], kNonlinear, key);
    oracle::expect_close(fit->b_interval->high, interval[1], kNonlinear, key);
    EXPECT_FALSE(fit->at_bound || fit->not_identified);
    const double squares = fit->residual_deviation * fit->residual_deviation * 8.0;
    oracle::expect_close(aicc(squares, 10, 3), oracle::value(key + "AICc"), kDefault, key);
  }
}

TEST(PowerLaw, LogLogFitAgreesWithLinearRegressionInR) {
  for (const auto& [name, seconds] : reference_series()) {
    const auto fit = fit_power_law(ordinals(seconds.size()), seconds, PowerLawScale::log_log);
    ASSERT_TRUE(fit) << name;
    const std::string key = name + ".powerlog.";
    oracle::expect_close(fit->a, oracle::value(key + "a"), kDefault, key);
    oracle::expect_close(fit->b, oracle::value(key + "b"), kDefault, key);
    oracle::expect_close(100.0 * fit->learning_rate, oracle::value(key + "learning_rate_pct"),
                         kDefault, key);
    oracle::expect_close(*fit->r_squared, oracle::value(key + "r2_logscale"), kDefault, key);
    const auto interval = oracle::values(key + "b_ci95");
    oracle::expect_close(fit->b_interval->low, interval[0], kDefault, key);
    oracle::expect_close(fit->b_interval->high, interval[1], kDefault, key);
  }
}

TEST(StepChange, AgreesWithTheTwoMeanSplitInR) {
  for (const auto& [name, seconds] : reference_series()) {
    const auto step = find_step_change(seconds);
    ASSERT_TRUE(step) << name;
    const std::string key = name + ".step.";
    EXPECT_EQ(step->last_before, oracle::value(key + "last_trial_before_change"));
    oracle::expect_close(step->mean_before, oracle::value(key + "mean_before"), kDefault, key);
    oracle::expect_close(step->mean_after, oracle::value(key + "mean_after"), kDefault, key);
    oracle::expect_close(step->residual_squares, oracle::value(key + "rss"), kDefault, key);
    oracle::expect_close(aicc(step->residual_squares, 10, 4), oracle::value(key + "AICc"), kDefault,
                         key);
  }
}

// The two groups' samples that the reference file compares, by the name it gives the comparison.
struct GroupPair {
  std::vector<double> expert, novice;
};

GroupPair pair_of(const std::string& name) {
  GroupPair pair;
  for (const auto& [participant, seconds] : oracle::linear_seconds()) {
    auto& group = participant <= "No.3" ? pair.expert : pair.novice;
    if (name == "alltrials") group.insert(group.end(), seconds.begin(), seconds.end());
    if (name == "pmeans") group.push_back(mean_of(seconds));
    if (name == "first") group.push_back(seconds.front());
    if (name == "last") group.push_back(seconds.back());
    if (name == "last3") group.push_back(mean_of(std::span(seconds).last(3)));
    if (name == "improvement") {
      group.push_back(100.0 * (seconds.front() - seconds.back()) / seconds.front());
    }
  }
  return pair;
}

class GroupComparison : public testing::TestWithParam<const char*> {
 protected:
  GroupPair pair_ = pair_of(GetParam());
  double reference(const std::string& key) const {
    return oracle::value("linear." + std::string(GetParam()) + "." + key);
  }
  std::vector<double> references(const std::string& key) const {
    return oracle::values("linear." + std::string(GetParam()) + "." + key);
  }
};

TEST_P(GroupComparison, RanksAgreeWithExactTestsInR) {
  const auto test = rank_test(pair_.expert, pair_.novice);
  ASSERT_TRUE(test);
  EXPECT_TRUE(test->exact);
  EXPECT_EQ(test->u_first, reference("U_expert"));
  EXPECT_EQ(test->u_second, reference("U_novice"));
  // below 1e-10 the reference itself is good to three digits
  const double p = reference("mw_p_exact_two_sided");
  oracle::expect_close(test->p_two_sided / p, 1.0, p < 1e-10 ? 1e-3 : kDefault, "p");
}

TEST_P(GroupComparison, EffectSizeAgreesWithR) {
  const auto effect = hedges_g(pair_.expert, pair_.novice);
  ASSERT_TRUE(effect);
  oracle::expect_close(effect->cohen_d, reference("cohen_d"), kDefault, "d");
  oracle::expect_close(effect->g, reference("hedges_g"), kDefault, "g");
  oracle::expect_close(effect->correction, reference("hedges_J_exact"), kDefault, "J");
  oracle::expect_close(effect->pooled_deviation, reference("s_pooled"), kDefault, "s");
  const auto interval = references("hedges_g_ci95_nct");
  ASSERT_TRUE(effect->interval);
  oracle::expect_close(effect->interval->low, interval[0], kNonCentral, "low");
  oracle::expect_close(effect->interval->high, interval[1], kNonCentral, "high");
}

TEST_P(GroupComparison, DominanceAgreesWithPairCounts) {
  const auto result = dominance(pair_.expert, pair_.novice);
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->cliffs_delta, reference("cliffs_delta"), 1e-12);
  EXPECT_NEAR(result->first_lower, reference("auc_novice_slower"), 1e-12);
  EXPECT_EQ(result->complete_separation, std::abs(reference("cliffs_delta")) == 1.0);
}

TEST_P(GroupComparison, WelchAgreesWithR) {
  const auto difference = welch(pair_.expert, pair_.novice);
  ASSERT_TRUE(difference);
  oracle::expect_close(difference->t, reference("welch_t"), kDefault, "t");
  oracle::expect_close(difference->degrees_of_freedom, reference("welch_df"), kDefault, "df");
  const double p = reference("welch_p");
  oracle::expect_close(difference->p_two_sided / p, 1.0, p < 1e-10 ? 1e-3 : kDefault, "p");
  const auto interval = references("welch_ci95");
  oracle::expect_close(difference->interval.low, interval[0], kDefault, "low");
  oracle::expect_close(difference->interval.high, interval[1], kDefault, "high");
}

INSTANTIATE_TEST_SUITE_P(Linear, GroupComparison,
                         testing::Values("pmeans", "alltrials", "first", "last", "last3",
                                         "improvement"),
                         [](const auto& comparison) { return std::string(comparison.param); });

}  // namespace
}  // namespace assessment
