#include "assessment/statistics/rank_test.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/assessment/oracle.h"

namespace assessment {
namespace {

double count_won(const std::vector<double>& first, const std::vector<double>& second) {
  double won = 0.0;
  for (const double x : first) {
    for (const double y : second) won += x > y ? 1.0 : (x == y ? 0.5 : 0.0);
  }
  return won;
}

// All ways to deal the pooled values out, one by one.
double brute_force_p(const std::vector<double>& first, const std::vector<double>& second) {
  std::vector<double> pooled = first;
  pooled.insert(pooled.end(), second.begin(), second.end());
  std::vector<int> belongs(pooled.size(), 0);
  std::fill(belongs.begin(), belongs.begin() + static_cast<std::ptrdiff_t>(first.size()), 1);
  std::sort(belongs.begin(), belongs.end());
  const double middle = 0.5 * static_cast<double>(first.size() * second.size());
  const double observed = std::abs(count_won(first, second) - middle);
  double all = 0.0, extreme = 0.0;
  do {
    std::vector<double> dealt_first, dealt_second;
    for (std::size_t i = 0; i < pooled.size(); ++i) {
      (belongs[i] == 1 ? dealt_first : dealt_second).push_back(pooled[i]);
    }
    all += 1.0;
    // U moves in halves, so a quarter separates equal from different
    if (std::abs(count_won(dealt_first, dealt_second) - middle) > observed - 0.25) extreme += 1.0;
  } while (std::next_permutation(belongs.begin(), belongs.end()));
  return extreme / all;
}

TEST(RankTest, EqualsTheCountOverAllDealsWithAndWithoutTies) {
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round) {
    const int n1 = 1 + static_cast<int>(random() % 5), n2 = 1 + static_cast<int>(random() % 5);
    const unsigned levels = round % 2 == 0 ? 3 : 1000;  // many ties, or hardly any
    std::vector<double> first, second;
    for (int i = 0; i < n1; ++i) first.push_back(static_cast<double>(random() % levels));
    for (int i = 0; i < n2; ++i) second.push_back(static_cast<double>(random() % levels));
    const auto test = rank_test(first, second);
    ASSERT_TRUE(test);
    EXPECT_TRUE(test->exact);
    EXPECT_EQ(test->u_first, count_won(first, second));
    EXPECT_EQ(test->u_first, pairs_won(first, second));
    EXPECT_EQ(test->u_first + test->u_second, n1 * n2);
    // both count whole deals; only the quotient rounds
    EXPECT_NEAR(test->p_two_sided, brute_force_p(first, second), 1e-14);
  }
}

TEST(RankTest, TheFloorOfPIsWhatTheGroupSizesAllow) {
  for (const int n : {3, 4, 5, 6}) {
    const std::string size = std::to_string(n);
    // the reference is printed with 15 digits
    oracle::expect_close(smallest_rank_p(n, n),
                         oracle::value("power.min_p_mannwhitney_" + size + "v" + size), 1e-13,
                         size);
  }
  EXPECT_EQ(smallest_rank_p(1, 1), 1.0);
  EXPECT_NEAR(smallest_rank_p(30, 30) / oracle::value("reference.choose_60_30_p"), 1.0, 1e-10);
}

TEST(RankTest, IsSymmetricAndBlindToAnyOrderPreservingChange) {
  const std::vector<double> first{3, 5, 9, 11}, second{4, 10, 12, 13, 14};
  std::vector<double> first_log, second_log;
  for (const double x : first) first_log.push_back(std::log(x));
  for (const double x : second) second_log.push_back(std::log(x));
  const auto test = rank_test(first, second), swapped = rank_test(second, first),
             logs = rank_test(first_log, second_log);
  EXPECT_EQ(test->p_two_sided, swapped->p_two_sided);
  EXPECT_EQ(test->u_first, swapped->u_second);
  EXPECT_EQ(test->p_two_sided, logs->p_two_sided);
}

TEST(RankTest, LargeGroupsGetTheNormalApproximationAndSaySo) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> first, second;
  for (int i = 0; i < 90; ++i) first.push_back(normal(random));
  for (int i = 0; i < 90; ++i) second.push_back(normal(random) + 0.3);
  const auto exact = rank_test(first, second);
  EXPECT_TRUE(exact->exact);
  // what the approximation gives for the same U; the two agree to about 1 / n
  const double variance = 90.0 * 90.0 * 181.0 / 12.0;
  const double z = (std::abs(exact->u_first - 4050.0) - 0.5) / std::sqrt(variance);
  EXPECT_NEAR(exact->p_two_sided, std::erfc(z / std::sqrt(2.0)), 2e-3);

  for (int i = 0; i < 1000; ++i) first.push_back(normal(random));
  for (int i = 0; i < 1000; ++i) second.push_back(normal(random) + 0.3);
  const auto large = rank_test(first, second);
  EXPECT_FALSE(large->exact);
  EXPECT_GT(large->p_two_sided, 0.0);
  EXPECT_LT(large->p_two_sided, 1e-3);
}

TEST(RankTest, AllTiesSayNothing) {
  const std::vector<double> same{2, 2, 2};
  const auto test = rank_test(same, same);
  ASSERT_TRUE(test);
  EXPECT_EQ(test->p_two_sided, 1.0);
  EXPECT_EQ(test->u_first, 4.5);
  EXPECT_TRUE(test->tied);
  const std::vector<double> many(2000, 1.0);
  EXPECT_EQ(rank_test(many, many)->p_two_sided, 1.0);
}

}  // namespace
}  // namespace assessment
