#include "sim/dynamics/rod_contact_force.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace sim {

RodContactForce::RodContactForce(std::size_t node_capacity)
    : place_(node_capacity + 1, 0.0),
      sum_(node_capacity + 1, Vec3::Zero()),
      slope_(node_capacity + 1, Vec3::Zero()) {}

// Cubic Hermite pieces. The slope where two cells meet is van Albada's mean of theirs: the plain
// mean when they are alike, zero when one of them is zero or they oppose each other.
void RodContactForce::interpolate(std::span<const Vec3> forces, std::span<const double> cells) {
  cell_count_ = cells.size();
  for (std::size_t i = 0; i < cell_count_; ++i) {
    place_[i + 1] = place_[i] + cells[i];
    sum_[i + 1] = sum_[i] + forces[i];
    if (i + 1 == cell_count_) continue;
    const Vec3 a = forces[i] / cells[i];
    const Vec3 b = forces[i + 1] / cells[i + 1];
    const double aa = a.squaredNorm();
    const double bb = b.squaredNorm();
    slope_[i + 1] = a.dot(b) > 0.0 ? Vec3((bb * a + aa * b) / (aa + bb)) : Vec3::Zero();
  }
  if (cell_count_ == 0) return;
  slope_[0] = forces[0] / cells[0];
  slope_[cell_count_] = forces[cell_count_ - 1] / cells[cell_count_ - 1];
}

// Sum of the forces before `place`; `cell` is where to start looking and moves on with it.
Vec3 RodContactForce::sum_at(double place, std::size_t& cell) const {
  if (place <= 0.0) return Vec3::Zero();
  if (place >= place_[cell_count_]) return sum_[cell_count_];
  while (place_[cell + 1] <= place) ++cell;
  const double length = place_[cell + 1] - place_[cell];
  const double t = (place - place_[cell]) / length;
  const double u = 1.0 - t;
  return u * u * (1.0 + 2.0 * t) * sum_[cell] + t * t * (3.0 - 2.0 * t) * sum_[cell + 1] +
         t * u * length * (u * slope_[cell] - t * slope_[cell + 1]);
}

double RodContactForce::largest(std::span<const Vec3> forces, std::span<const double> cells) {
  assert(forces.size() == cells.size() && cells.size() < place_.size());
  interpolate(forces, cells);
  // windows that end, and windows that start, at the quarters of each loaded cell
  constexpr int kParts = 4;
  double most = 0.0;
  std::size_t end_cell = 0;
  std::size_t start_cell = 0;
  std::size_t here = 0;
  for (std::size_t i = 0; i < cell_count_; ++i) {
    if (forces[i].squaredNorm() <= 0.0) continue;
    for (int part = 0; part <= kParts; ++part) {
      const double place = place_[i] + cells[i] * part / kParts;
      const Vec3 sum = sum_at(place, here);
      most = std::max(most, (sum_at(place + kContactWindow, end_cell) - sum).squaredNorm());
      most = std::max(most, (sum - sum_at(place - kContactWindow, start_cell)).squaredNorm());
    }
  }
  return std::sqrt(most);
}

double largest_contact_force(std::span<const Vec3> forces, std::span<const double> cells) {
  return RodContactForce(cells.size()).largest(forces, cells);
}

}  // namespace sim
