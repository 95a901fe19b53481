// Signed distance to the smooth surface that a triangle mesh stands for.
//
//        true wall  _.-'''-._          a facet cuts the corner by edge^2 / (8 radius), and its
//      facets      /_________\         normal is off by edge / (2 radius): 5 degrees on a vessel
//                                      of 3 mm. The vertex normals know better.
//
// Where the vertex normals of a triangle agree with it, the distance is taken to the curved patch
// they span; at creases, to the facets themselves. Positive inside.
#pragma once

#include <array>
#include <vector>

#include "sim/anatomy/triangle_mesh.h"
#include "sim/contact/triangle_tree.h"
#include "sim/contact/wall.h"
#include "sim/math/vec3.h"

namespace sim {

class SurfaceDistance {
 public:
  // The mesh must be closed, wound counter-clockwise seen from outside, and outlive this. Vertex
  // normals are computed where the mesh has none. Throws std::invalid_argument when the mesh is
  // empty, invalid or open.
  explicit SurfaceDistance(const TriangleMesh& mesh);

  // Distance and its gradient. `close_by` is the answer for a point nearby, if there is one, and
  // becomes the answer for this one.
  WallSample sample(const Vec3& point, NearestTriangle& close_by) const;

  // Signed distance to the facets, no curvature. For tests and for what is coarse anyway.
  double facet_distance(const Vec3& point) const;

  const TriangleTree& tree() const { return tree_; }

 private:
  double side(const Vec3& point, const NearestTriangle& nearest) const;

  const TriangleMesh& mesh_;
  TriangleTree tree_;
  std::vector<Vec3> normals_;                      // per vertex, for the patches
  std::vector<Vec3> facet_normals_;                // unit
  std::vector<Vec3> corner_normals_;               // per vertex, weighted by angle: the side
  std::vector<std::array<Vec3, 3>> edge_normals_;  // per triangle; [k] opposite of corner k
  std::vector<char> curved_;                       // per triangle: the patch may be used
};

}  // namespace sim
