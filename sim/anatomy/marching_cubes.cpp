#include "sim/anatomy/marching_cubes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "sim/anatomy/cell_cases.h"
#include "sim/base/require.h"

namespace sim {
namespace {

constexpr std::int32_t kNoVertex = -1;

// Root in (0, 1) of the cubic through `before`, `at0`, `at1`, `after` at -1, 0, 1, 2 (Catmull-Rom).
// at0 and at1 differ in sign. A linear root would be off by spacing^2 / (8 radius), in the pattern
// of the grid; this one follows a curved surface to the fourth order.
double crossing(double before, double at0, double at1, double after) {
  const double slope0 = (at1 - before) / 2.0;
  const double slope1 = (after - at0) / 2.0;
  const double c2 = 3.0 * (at1 - at0) - 2.0 * slope0 - slope1;
  const double c3 = 2.0 * (at0 - at1) + slope0 + slope1;
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 24; ++i) {  // 2^-24 of a voxel
    const double t = (low + high) / 2.0;
    const double value = at0 + t * (slope0 + t * (c2 + t * c3));
    ((value > 0.0) == (at0 > 0.0) ? low : high) = t;
  }
  // off the grid point itself, where up to six vertices would coincide
  constexpr double kMargin = 1e-3;
  return std::clamp((low + high) / 2.0, kMargin, 1.0 - kMargin);
}

// Walks through the layers of cells with four slices in memory. The volume is surrounded by one
// voxel of outside; coordinates below count from that border.
class Marcher {
 public:
  Marcher(const VolumeShape& shape, const SliceSource& source, float threshold)
      : shape_(shape), source_(source), threshold_(threshold) {
    for (std::size_t a = 0; a < 3; ++a) {
      base::require(shape.size[a] > 0, "a volume needs at least one voxel along each axis");
      base::require(std::isfinite(shape.spacing[static_cast<Eigen::Index>(a)]) &&
                        shape.spacing[static_cast<Eigen::Index>(a)] > 0.0,
                    "the voxel spacing must be positive");
      size_[a] = shape.size[a] + 2;
    }
    row_ = static_cast<std::size_t>(size_[0]);
    const std::size_t area = row_ * static_cast<std::size_t>(size_[1]);
    for (auto& slice : slices_) slice.resize(area);
    for (auto& map : in_slice_) map.assign(2 * area, kNoVertex);
    between_.assign(area, kNoVertex);
    voxels_.resize(static_cast<std::size_t>(shape.size[0]) *
                   static_cast<std::size_t>(shape.size[1]));
  }

  TriangleMesh run() {
    for (int z = 0; z < 3 && z < size_[2]; ++z) load(z);
    for (int z = 0; z + 1 < size_[2]; ++z) {
      if (z + 2 < size_[2] && z > 0) load(z + 2);
      std::fill(between_.begin(), between_.end(), kNoVertex);
      std::fill(in_slice_[1].begin(), in_slice_[1].end(), kNoVertex);
      march_layer(z);
      std::swap(in_slice_[0], in_slice_[1]);
    }
    return std::move(mesh_);
  }

 private:
  std::vector<float>& slice(int z) { return slices_[static_cast<std::size_t>(z) % 4]; }

  // Slice z with its border, as values above the threshold.
  void load(int z) {
    std::vector<float>& target = slice(z);
    std::fill(target.begin(), target.end(), -1.0F);
    if (z == 0 || z + 1 == size_[2]) return;
    source_(z - 1, voxels_);
    const auto width = static_cast<std::size_t>(shape_.size[0]);
    for (std::size_t i = 0; i < voxels_.size(); ++i) {
      base::require(std::isfinite(voxels_[i]), "the volume holds a value that is not a number");
      target[(i / width + 1) * row_ + i % width + 1] = voxels_[i] - threshold_;
    }
  }

  double value(int x, int y, int z) {
    x = std::clamp(x, 0, size_[0] - 1);
    y = std::clamp(y, 0, size_[1] - 1);
    z = std::clamp(z, 0, size_[2] - 1);
    return static_cast<double>(
        slice(z)[static_cast<std::size_t>(y) * row_ + static_cast<std::size_t>(x)]);
  }

  Vec3 gradient(int x, int y, int z) {
    return Vec3(value(x + 1, y, z) - value(x - 1, y, z), value(x, y + 1, z) - value(x, y - 1, z),
                value(x, y, z + 1) - value(x, y, z - 1))
        .cwiseQuotient(shape_.spacing);
  }

  void march_layer(int z) {
    for (int y = 0; y + 1 < size_[1]; ++y) {
      for (int x = 0; x + 1 < size_[0]; ++x) {
        unsigned mask = 0;
        for (int c = 0; c < 8; ++c) {
          if (value(x + (c & 1), y + ((c >> 1) & 1), z + (c >> 2)) > 0.0) mask |= 1U << c;
        }
        if (mask == 0 || mask == 255) continue;
        for (const auto& edges : cell_cases()[mask]) {
          std::array<std::int32_t, 3> triangle{};
          for (std::size_t i = 0; i < 3; ++i) triangle[i] = vertex(x, y, z, edges[i]);
          mesh_.triangles.push_back(triangle);
        }
      }
    }
  }

  // The vertex on an edge of cell (x, y, z); made by the first cell that asks for it.
  std::int32_t vertex(int x, int y, int z, int cell_edge) {
    const CellEdge& edge = cell_edges()[static_cast<std::size_t>(cell_edge)];
    const int gx = x + (edge.from & 1), gy = y + ((edge.from >> 1) & 1), gz = z + (edge.from >> 2);
    const std::size_t point = static_cast<std::size_t>(gy) * row_ + static_cast<std::size_t>(gx);
    std::int32_t& index = edge.axis == 2
                              ? between_[point]
                              : in_slice_[static_cast<std::size_t>(gz - z)]
                                         [2 * point + static_cast<std::size_t>(edge.axis)];
    if (index == kNoVertex) {
      index = static_cast<std::int32_t>(mesh_.vertices.size());
      add_vertex(gx, gy, gz, edge.axis);
    }
    return index;
  }

  void add_vertex(int x, int y, int z, int axis) {
    const int dx = axis == 0, dy = axis == 1, dz = axis == 2;
    const auto along = [&](int k) { return value(x + k * dx, y + k * dy, z + k * dz); };
    const double t = crossing(along(-1), along(0), along(1), along(2));
    const Vec3 grid = Vec3(x - 1 + t * dx, y - 1 + t * dy, z - 1 + t * dz);
    mesh_.vertices.push_back(shape_.origin + grid.cwiseProduct(shape_.spacing));

    const Vec3 outward = -((1.0 - t) * gradient(x, y, z) + t * gradient(x + dx, y + dy, z + dz));
    const double length = outward.norm();
    // a gradient that vanishes at a crossing: down the edge itself
    const double down = along(0) > 0.0 ? 1.0 : -1.0;
    mesh_.normals.push_back(length > 1e-12 ? Vec3(outward / length)
                                           : Vec3(down * Vec3(dx, dy, dz)));
  }

  const VolumeShape& shape_;
  const SliceSource& source_;
  float threshold_;
  std::array<int, 3> size_{};
  std::size_t row_ = 0;
  std::array<std::vector<float>, 4> slices_;
  std::vector<float> voxels_;
  std::array<std::vector<std::int32_t>, 2> in_slice_;  // x and y edges of the layer's two slices
  std::vector<std::int32_t> between_;                  // z edges of the layer
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh marching_cubes(const VolumeShape& shape, const SliceSource& source, float threshold) {
  return Marcher(shape, source, threshold).run();
}

}  // namespace sim
