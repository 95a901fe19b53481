// The linear system of a rod: 4 unknowns per node, each coupled to at most two nodes on either
// side. Not symmetric (friction), solved by LU without pivoting.
//
// Unknowns in the order x0 y0 z0 twist0 x1 y1 z1 twist1 ... ; a row reaches at most 10 columns to
// either side, and a column eliminates at most 10, 9, 8, 7 rows below it for x, y, z, twist.
#pragma once

#include <cstddef>
#include <vector>

namespace sim {

class RodBand {
 public:
  static constexpr std::size_t kReach = 10;
  static constexpr std::size_t kStride = 2 * kReach + 1;

  explicit RodBand(std::size_t node_capacity);

  // Entry (row, row + offset) is at row(i)[kReach + offset].
  double* row(std::size_t i) { return entries_.data() + i * kStride; }
  const double* row(std::size_t i) const { return entries_.data() + i * kStride; }
  double& at(std::size_t i, std::size_t j) { return row(i)[kReach + j - i]; }
  double at(std::size_t i, std::size_t j) const { return row(i)[kReach + j - i]; }

  // Solves A x = b for the first `size` unknowns; b is replaced by x. Destroys the matrix.
  // `right_side` must have room for size + kReach values.
  void solve(std::size_t size, double* right_side);

 private:
  std::vector<double> entries_;
};

}  // namespace sim
