#include "assessment/motion/low_pass.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace assessment {
namespace {

struct Biquad {
  double b0, b1, b2, a1, a2;
};

// Bilinear transform with the cut-off pre-warped.
Biquad butterworth(double rate, double cut_off) {
  const double k = std::tan(std::numbers::pi * cut_off / rate);
  const double norm = 1.0 / (1.0 + std::numbers::sqrt2 * k + k * k);
  const double b0 = k * k * norm;
  return {b0, 2.0 * b0, b0, 2.0 * (k * k - 1.0) * norm,
          (1.0 - std::numbers::sqrt2 * k + k * k) * norm};
}

// In place, from the steady state of a series that has always had its first value.
template <typename Iterator>
void run(const Biquad& filter, Iterator begin, Iterator end) {
  double z1 = (1.0 - filter.b0) * *begin;
  double z2 = (filter.b2 - filter.a2) * *begin;
  for (Iterator it = begin; it != end; ++it) {
    const double x = *it;
    const double y = filter.b0 * x + z1;
    z1 = filter.b1 * x - filter.a1 * y + z2;
    z2 = filter.b2 * x - filter.a2 * y;
    *it = y;
  }
}

}  // namespace

std::vector<double> low_pass(std::span<const double> values, double rate, double cut_off) {
  assert(cut_off > 0.0 && cut_off < 0.5 * rate);
  std::vector<double> result(values.begin(), values.end());
  if (values.size() < 2) return result;

  const std::size_t margin = std::min<std::size_t>(9, values.size() - 1);
  std::vector<double> padded;
  padded.reserve(values.size() + 2 * margin);
  for (std::size_t i = margin; i >= 1; --i) padded.push_back(2.0 * values.front() - values[i]);
  padded.insert(padded.end(), values.begin(), values.end());
  for (std::size_t i = 1; i <= margin; ++i) {
    padded.push_back(2.0 * values.back() - values[values.size() - 1 - i]);
  }
  const Biquad filter = butterworth(rate, cut_off);
  run(filter, padded.begin(), padded.end());
  run(filter, padded.rbegin(), padded.rend());
  std::copy_n(padded.begin() + static_cast<std::ptrdiff_t>(margin), values.size(), result.begin());
  return result;
}

}  // namespace assessment
