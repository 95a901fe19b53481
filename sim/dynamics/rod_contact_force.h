// The contact force, one definition for gauges, limits, hits, perforation and metrics: the largest
// norm of the vector sum of wall reactions over any 6 mm of the instrument's length.
//
// A node's force stands for its cell, so the sum of all forces up to a point is known exactly where
// cells meet. In between it is interpolated smoothly without overshoot; that makes the answer
// depend little on the mesh, for a load spread along the wall and for one at a point alike.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/math/vec3.h"

namespace sim {

inline constexpr double kContactWindow = 6.0;  // mm

class RodContactForce {
 public:
  explicit RodContactForce(std::size_t node_capacity);

  // `forces`: the wall's reaction on each node, N; `cells`: the length each node stands for, mm;
  // in the same order along the instrument. Allocates nothing.
  double largest(std::span<const Vec3> forces, std::span<const double> cells);

 private:
  Vec3 sum_at(double place, std::size_t& cell) const;
  void interpolate(std::span<const Vec3> forces, std::span<const double> cells);

  // where cells meet, the ends included: place in mm, sum of the forces before it, its slope
  std::vector<double> place_;
  std::vector<Vec3> sum_, slope_;
  std::size_t cell_count_ = 0;
};

// The same, for one call.
double largest_contact_force(std::span<const Vec3> forces, std::span<const double> cells);

}  // namespace sim
