// The surface between inside and outside of a volume, by marching cubes.
//
// For every volume the result is closed and 2-manifold: each edge belongs to exactly two
// triangles, each vertex to one fan. What reaches the border of the volume is closed there.
// The volume is read slice by slice and only four slices are held, so that its size is limited
// by the surface, not by the memory for the voxels.
#pragma once

#include <array>
#include <functional>
#include <span>

#include "sim/anatomy/triangle_mesh.h"
#include "sim/math/vec3.h"

namespace sim {

// Where the voxels' centres are.
struct VolumeShape {
  std::array<int, 3> size{};           // voxels along x, y, z
  Vec3 origin = Vec3::Zero();          // mm, centre of the first voxel
  Vec3 spacing = Vec3::Constant(1.0);  // mm
};

// Fills slice z: values[x + size[0] * y]. Called once per slice, in ascending order.
using SliceSource = std::function<void(int z, std::span<float> values)>;

// Inside is where the value exceeds `threshold`. Vertices lie where a cubic through the four
// values along the grid edge crosses it; normals point down the volume's gradient. Throws
// std::invalid_argument when the shape is empty or a value is not finite.
TriangleMesh marching_cubes(const VolumeShape& shape, const SliceSource& source, float threshold);

}  // namespace sim
