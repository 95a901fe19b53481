// A surface as shared vertices and triangles. Triangles wind counter-clockwise seen from outside.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/math/vec3.h"

namespace sim {

struct TriangleMesh {
  std::vector<Vec3> vertices;                          // mm
  std::vector<Vec3> normals;                           // unit, outward, one per vertex
  std::vector<std::array<std::int32_t, 3>> triangles;  // indices into vertices
};

}  // namespace sim
