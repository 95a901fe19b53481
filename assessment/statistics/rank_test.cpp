#include "assessment/statistics/rank_test.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "assessment/statistics/descriptive.h"

namespace assessment {
namespace {

// Bound on the additions of the exact count: 100 against 100 without ties stay below it.
constexpr double kLargestWork = 4e8;

struct PooledRanks {
  std::vector<std::int64_t> doubled;  // 2 x midrank of each pooled value, ascending
  std::int64_t doubled_first = 0;     // sum over the first group
  double tie_term = 0.0;              // sum over ties of t^3 - t
};

PooledRanks pool(std::span<const double> first, std::span<const double> second) {
  struct Entry {
    double value;
    bool in_first;
  };
  std::vector<Entry> entries;
  entries.reserve(first.size() + second.size());
  for (const double value : first) entries.push_back({value, true});
  for (const double value : second) entries.push_back({value, false});
  std::sort(entries.begin(), entries.end(),
            [](const Entry& x, const Entry& y) { return x.value < y.value; });

  PooledRanks ranks;
  ranks.doubled.resize(entries.size());
  for (std::size_t begin = 0; begin < entries.size();) {
    std::size_t end = begin;
    while (end < entries.size() && entries[end].value == entries[begin].value) ++end;
    // ranks begin+1 .. end share their mean, so twice that is begin + 1 + end
    const auto doubled = static_cast<std::int64_t>(begin + 1 + end);
    const auto ties = static_cast<double>(end - begin);
    ranks.tie_term += ties * ties * ties - ties;
    for (std::size_t i = begin; i < end; ++i) {
      ranks.doubled[i] = doubled;
      if (entries[i].in_first) ranks.doubled_first += doubled;
    }
    begin = end;
  }
  return ranks;
}

// The share of all ways to choose `count` of `scores` whose sum lies at least `distance` from the
// middle, where distance and sums are whole numbers. `twice_middle` is twice the mean sum.
double two_sided_share(std::span<const std::int64_t> scores, std::size_t count,
                       std::int64_t twice_middle, std::int64_t twice_distance,
                       std::int64_t largest_sum) {
  const auto width = static_cast<std::size_t>(largest_sum) + 1;
  // ways[k * width + s]: choices of k scores with sum s among the scores seen so far
  std::vector<double> ways((count + 1) * width, 0.0);
  ways[0] = 1.0;
  std::size_t seen = 0;
  std::int64_t reach = 0;  // no sum so far is larger
  for (const std::int64_t score : scores) {
    ++seen;
    reach = std::min(reach + score, largest_sum);
    const auto shift = static_cast<std::size_t>(score);
    for (std::size_t k = std::min(seen, count); k >= 1; --k) {
      double* const to = ways.data() + k * width;
      const double* const from = ways.data() + (k - 1) * width;
      for (std::size_t s = shift; s <= static_cast<std::size_t>(reach); ++s) {
        to[s] += from[s - shift];
      }
    }
  }
  const double* const row = ways.data() + count * width;
  double all = 0.0, extreme = 0.0;
  for (std::size_t s = 0; s < width; ++s) {
    all += row[s];
    const std::int64_t away = std::abs(2 * static_cast<std::int64_t>(s) - twice_middle);
    if (away >= twice_distance) extreme += row[s];
  }
  return std::min(1.0, extreme / all);
}

// Kendall and Stuart's normal approximation, with the variance corrected for ties and half a unit
// for continuity.
double normal_p(double u, double n1, double n2, double tie_term) {
  const double n = n1 + n2;
  const double variance = n1 * n2 / 12.0 * ((n + 1.0) - tie_term / (n * (n - 1.0)));
  if (!(variance > 0.0)) return 1.0;  // all values equal
  const double away = std::max(0.0, std::abs(u - n1 * n2 / 2.0) - 0.5);
  return std::erfc(away / std::sqrt(2.0 * variance));
}

}  // namespace

double pairs_won(std::span<const double> first, std::span<const double> second) {
  const auto n1 = static_cast<double>(first.size());
  return static_cast<double>(pool(first, second).doubled_first) / 2.0 - n1 * (n1 + 1.0) / 2.0;
}

double smallest_rank_p(int first_count, int second_count) {
  if (first_count < 1 || second_count < 1) return 1.0;
  const double ways = std::exp(std::lgamma(first_count + second_count + 1.0) -
                               std::lgamma(first_count + 1.0) - std::lgamma(second_count + 1.0));
  // below 2^53 the number of ways is a whole number that the gamma functions miss by a few ulp
  const double whole = ways < 1e15 ? std::round(ways) : ways;
  return std::min(1.0, 2.0 / whole);
}

base::Result<RankTest> rank_test(std::span<const double> first, std::span<const double> second) {
  if (first.empty() || second.empty()) {
    return base::Error{base::ErrorCode::not_enough_data,
                       "a rank test needs at least one value in each group"};
  }
  if (!all_usable(first) || !all_usable(second)) {
    return base::Error{base::ErrorCode::invalid_input,
                       "a value is not a number that can be computed with"};
  }
  const auto n1 = static_cast<double>(first.size());
  const auto n2 = static_cast<double>(second.size());
  const PooledRanks ranks = pool(first, second);

  RankTest test;
  test.first_count = static_cast<int>(first.size());
  test.second_count = static_cast<int>(second.size());
  test.tied = ranks.tie_term > 0.0;
  test.u_first = static_cast<double>(ranks.doubled_first) / 2.0 - n1 * (n1 + 1.0) / 2.0;
  test.u_second = n1 * n2 - test.u_first;
  test.p_floor = smallest_rank_p(test.first_count, test.second_count);

  // count the smaller group's sums; the larger one's follow from them
  const std::size_t count = std::min(first.size(), second.size());
  const std::int64_t total =
      std::accumulate(ranks.doubled.begin(), ranks.doubled.end(), std::int64_t{0});
  const std::int64_t observed =
      first.size() <= second.size() ? ranks.doubled_first : total - ranks.doubled_first;
  const std::int64_t unit = test.tied ? 1 : 2;  // untied midranks are whole: halve the table
  std::vector<std::int64_t> scores(ranks.doubled);
  for (std::int64_t& score : scores) score /= unit;
  const auto pooled = static_cast<std::int64_t>(scores.size());
  const std::int64_t twice_middle = 2 * static_cast<std::int64_t>(count) * (pooled + 1) / unit;
  const std::int64_t twice_distance = std::abs(2 * observed / unit - twice_middle);
  const std::int64_t largest_sum = std::accumulate(
      scores.end() - static_cast<std::ptrdiff_t>(count), scores.end(), std::int64_t{0});

  const double work =
      static_cast<double>(pooled) * static_cast<double>(count) * static_cast<double>(largest_sum);
  test.exact = work <= kLargestWork;
  test.p_two_sided = test.exact
                         ? two_sided_share(scores, count, twice_middle, twice_distance, largest_sum)
                         : normal_p(test.u_first, n1, n2, ranks.tie_term);
  return test;
}

}  // namespace assessment
