// The wall as a sparse grid of signed distances with stored gradients, surveyed once from a
// closed triangle surface.
//
//     +----+----+----+----+      bricks of 8 x 8 x 8 cells, only where the wall is within `band`;
//     |    |####|####|    |      at each grid point the distance and its gradient (4 floats).
//     |    |##__|__##|####|      Between grid points both are interpolated, so that the normal is
//     |####|#/  |  \#|####|      continuous: with the gradient of interpolated distances, which
//     +----+----+----+----+      jumps from cell to cell, the implicit solver stops converging.
//
// In the lumen further than the band from any wall: distance = band. Beyond the wall further than
// the band, and anywhere outside the grid: -kLost, so that nothing out there is silently free.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/anatomy/triangle_mesh.h"
#include "sim/contact/wall.h"
#include "sim/math/vec3.h"

namespace sim {

struct DistanceGridOptions {
  double spacing = 0.5;                 // mm between grid points
  double band = 3.0;                    // mm on either side of the wall
  std::size_t max_bytes = 300'000'000;  // of grid data
};

class DistanceGrid final : public Wall {
 public:
  static constexpr double kLost = 1000.0;  // mm

  // Takes a second or so for a vessel. Throws std::invalid_argument when the surface is not
  // closed, the options are not positive or the grid would exceed max_bytes.
  explicit DistanceGrid(const TriangleMesh& surface, const DistanceGridOptions& options = {});

  void sample(std::span<const Vec3> points, std::span<WallSample> samples) const override;

  double spacing() const { return spacing_; }
  std::size_t brick_count() const { return bricks_; }
  std::size_t bytes() const;

 private:
  static constexpr int kCells = 8;            // per brick edge
  static constexpr int kPoints = kCells + 1;  // the last layer is the next brick's first
  static constexpr std::size_t kBrickPoints = std::size_t{kPoints} * kPoints * kPoints;

  // Marks of bricks without data.
  static constexpr std::int32_t kInside = -1, kOutside = -2;

  using GridPoint = std::array<float, 4>;  // distance mm, gradient

  void interpolate(const Vec3& in_brick, std::size_t brick, WallSample& sample) const;
  class Survey;  // builds it

  double spacing_, band_;
  Vec3 origin_ = Vec3::Zero();
  std::array<std::int32_t, 3> size_{};  // bricks along each axis
  std::vector<std::int32_t> index_;     // brick number, or a mark
  std::vector<GridPoint> points_;       // kBrickPoints per brick, x fastest
  std::size_t bricks_ = 0;
};

}  // namespace sim
