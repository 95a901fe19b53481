// Finds the nearest triangle of a surface. A hierarchy of boxes, built once; the answer is exact.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "sim/anatomy/triangle_mesh.h"
#include "sim/math/vec3.h"

namespace sim {

// The point of a triangle nearest to another point. Weights of the corners sum to 1; those that
// are exactly zero tell whether it lies inside, on an edge or on a corner.
struct TrianglePoint {
  Vec3 position = Vec3::Zero();
  Vec3 weights = Vec3::Zero();
  double squared_distance = std::numeric_limits<double>::infinity();
};
TrianglePoint nearest_on_triangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c);

struct NearestTriangle : TrianglePoint {
  std::int32_t triangle = -1;  // index into the mesh; -1: none within the bound
  std::int32_t slot = -1;      // where the tree keeps it
};

class TriangleTree {
 public:
  // Throws std::invalid_argument when the mesh is empty or an index or coordinate is invalid.
  explicit TriangleTree(const TriangleMesh& mesh);

  // The nearest triangle within `bound` mm.
  NearestTriangle nearest(const Vec3& point,
                          double bound = std::numeric_limits<double>::infinity()) const;
  // The nearest triangle of all. The answer for a point close by makes it several times faster.
  NearestTriangle nearest(const Vec3& point, const NearestTriangle& close_by) const;

  Vec3 low() const { return nodes_.front().low; }
  Vec3 high() const { return nodes_.front().high; }

 private:
  struct Node {
    Vec3 low, high;
    std::int32_t first = 0;  // a leaf's first corner triple, or the second child
    std::int32_t count = 0;  // 0: not a leaf, its first child follows it
  };
  struct Corners {
    std::array<Vec3, 3> at;
    std::int32_t triangle;
  };

  void search(const Vec3& point, NearestTriangle& best) const;
  void try_triangle(const Vec3& point, std::size_t slot, NearestTriangle& best) const;
  void build(std::size_t begin, std::size_t end);

  std::vector<Node> nodes_;
  std::vector<Corners> corners_;  // in the order of the leaves
};

}  // namespace sim
