// What an instrument asks of the vessel wall. One interface, so that the solver does not know
// whether the answer comes from a distance grid, a mesh or a formula.
//
//        lumen   x ------> n            gap > 0: free, inside the lumen
//   -------------+------------- wall    gap < 0: the point lies beyond the wall
//
// Implementations must be smooth: normals interpolated across voxels and triangles, or the
// implicit solver stops converging (raw trilinear gradients are known not to work).
#pragma once

#include <span>

#include "sim/math/vec3.h"

namespace sim {

struct WallSample {
  double distance = 0.0;        // mm, signed: positive inside the lumen, negative beyond
  Vec3 normal = Vec3::UnitX();  // unit, points into the lumen: the gradient of distance
};

class Wall {
 public:
  virtual ~Wall() = default;

  // One sample per point. Both spans have the same size. Allocates nothing, never fails: a point
  // too far from any wall to be touched gets the largest distance the wall knows.
  virtual void sample(std::span<const Vec3> points, std::span<WallSample> samples) const = 0;
};

}  // namespace sim
