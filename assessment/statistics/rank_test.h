// Mann-Whitney U: do the values of one group tend to lie above those of the other?
//
//     U = R1 - n1 (n1 + 1) / 2,   R1 = sum of the midranks of the first group
//
// The p is exact: the midranks are dealt out to the two groups in every possible way, ties
// included, and p is the share of deals whose U is at least as far from n1 n2 / 2 as the one seen.
// The counting is a dynamic programme over the ranks, on doubled midranks where values are tied
// (Streitberg and Roehmel, Statistical Software Newsletter 12 (1986) 10). Groups too large for it
// (more than about 100 against 100) get the normal approximation, and `exact` says so.
#pragma once

#include <span>

#include "sim/base/result.h"

namespace assessment {

struct RankTest {
  int first_count = 0;
  int second_count = 0;
  double u_first = 0.0;   // pairs in which the first group's value is the larger, ties half
  double u_second = 0.0;  // n1 n2 - u_first
  double p_two_sided = 1.0;
  bool exact = true;  // false: normal approximation with tie and continuity correction
  bool tied = false;
  double p_floor = 1.0;  // the smallest p that groups of this size can ever give, without ties
};

// Fails with not_enough_data when a group is empty, invalid_input for a value that is not finite.
base::Result<RankTest> rank_test(std::span<const double> first, std::span<const double> second);

// U of the first group alone: in how many pairs its value is the larger, ties half. In n log n.
double pairs_won(std::span<const double> first, std::span<const double> second);

// 2 / C(n1 + n2, n1), at most 1: the two most extreme deals of the ranks.
double smallest_rank_p(int first_count, int second_count);

}  // namespace assessment
