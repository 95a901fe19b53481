#include "sim/dynamics/rod_band.h"

#include <algorithm>

namespace sim {
namespace {

constexpr std::size_t kStride = RodBand::kStride;

// Eliminates one column: `pivot` points at the diagonal entry. Entry (i + r, i) then lies at
// pivot + r (kStride - 1). The inverse of the pivot is kept in its place for the way back.
template <std::size_t kWidth>
inline void eliminate(double* __restrict pivot, double* __restrict right_side) {
  const double inverse = 1.0 / pivot[0];
  double top[kWidth];
  for (std::size_t j = 0; j < kWidth; ++j) top[j] = pivot[j + 1];
  for (std::size_t r = 1; r <= kWidth; ++r) {
    double* __restrict below = pivot + r * (kStride - 1);
    const double factor = below[0] * inverse;
    for (std::size_t j = 0; j < kWidth; ++j) below[j + 1] -= factor * top[j];
    right_side[r] -= factor * right_side[0];
  }
  pivot[0] = inverse;
}

template <std::size_t kWidth>
inline void substitute(const double* __restrict pivot, double* __restrict right_side) {
  double sum = right_side[0];
  for (std::size_t j = kWidth; j > 0; --j) sum -= pivot[j] * right_side[j];
  right_side[0] = sum * pivot[0];
}

}  // namespace

RodBand::RodBand(std::size_t node_capacity)
    : entries_((4 * node_capacity + 2 * kReach) * kStride, 0.0) {}

void RodBand::solve(std::size_t size, double* right_side) {
  // rows below the last unknown are read but must not matter
  std::fill(row(size), row(size + kReach), 0.0);
  std::fill(right_side + size, right_side + size + kReach, 0.0);

  const std::size_t whole = size - size % 4;
  double* diagonal = row(0) + kReach;
  for (std::size_t i = 0; i < whole; i += 4) {
    eliminate<10>(diagonal + i * kStride, right_side + i);
    eliminate<9>(diagonal + (i + 1) * kStride, right_side + i + 1);
    eliminate<8>(diagonal + (i + 2) * kStride, right_side + i + 2);
    eliminate<7>(diagonal + (i + 3) * kStride, right_side + i + 3);
  }
  for (std::size_t i = whole; i < size; ++i) eliminate<10>(diagonal + i * kStride, right_side + i);

  for (std::size_t i = size; i > whole; --i) {
    substitute<10>(diagonal + (i - 1) * kStride, right_side + i - 1);
  }
  for (std::size_t i = whole; i > 0; i -= 4) {
    substitute<7>(diagonal + (i - 1) * kStride, right_side + i - 1);
    substitute<8>(diagonal + (i - 2) * kStride, right_side + i - 2);
    substitute<9>(diagonal + (i - 3) * kStride, right_side + i - 3);
    substitute<10>(diagonal + (i - 4) * kStride, right_side + i - 4);
  }
}

}  // namespace sim
