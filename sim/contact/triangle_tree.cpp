#include "sim/contact/triangle_tree.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include <Eigen/Geometry>

#include "sim/base/require.h"

namespace sim {
namespace {

constexpr std::size_t kLeafSize = 4;

double squared_distance_to_box(const Vec3& point, const Vec3& low, const Vec3& high) {
  return (low - point).cwiseMax(point - high).cwiseMax(0.0).squaredNorm();
}

// Nearest on the edge from corner i to corner j; keeps the result if it is nearer.
void try_edge(const Vec3& point, const Vec3& from, const Vec3& to, Eigen::Index i, Eigen::Index j,
              TrianglePoint& best) {
  const Vec3 along = to - from;
  const double squared_length = along.squaredNorm();
  const double t =
      squared_length > 0.0 ? std::clamp((point - from).dot(along) / squared_length, 0.0, 1.0) : 0.0;
  const Vec3 position = from + t * along;
  const double squared_distance = (point - position).squaredNorm();
  if (squared_distance >= best.squared_distance) return;
  best.position = position;
  best.weights.setZero();
  best.weights[i] = 1.0 - t;
  best.weights[j] = t;
  best.squared_distance = squared_distance;
}

}  // namespace

TrianglePoint nearest_on_triangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
  // foot of the perpendicular in the coordinates a + v ab + w ac: normal equations
  const Vec3 ab = b - a, ac = c - a, ap = point - a;
  const double bb = ab.dot(ab), cc = ac.dot(ac), bc = ab.dot(ac);
  const double pb = ap.dot(ab), pc = ap.dot(ac);
  const double determinant = bb * cc - bc * bc;
  TrianglePoint best;
  const bool flat = determinant <= 1e-14 * bb * cc;  // a needle: its edges are all there is
  const double v = flat ? -1.0 : (cc * pb - bc * pc) / determinant;
  const double w = flat ? -1.0 : (bb * pc - bc * pb) / determinant;
  const double u = flat ? -1.0 : 1.0 - v - w;
  if (u > 0.0 && v > 0.0 && w > 0.0) {
    best.position = a + v * ab + w * ac;
    best.weights = Vec3(u, v, w);
    best.squared_distance = (point - best.position).squaredNorm();
    return best;
  }
  // outside: the nearest point lies on an edge that the foot is beyond
  if (u <= 0.0) try_edge(point, b, c, 1, 2, best);
  if (v <= 0.0) try_edge(point, c, a, 2, 0, best);
  if (w <= 0.0) try_edge(point, a, b, 0, 1, best);
  return best;
}

TriangleTree::TriangleTree(const TriangleMesh& mesh) {
  base::require(!mesh.triangles.empty(), "a surface needs at least one triangle");
  corners_.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Corners corners;
    corners.triangle = static_cast<std::int32_t>(i);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto vertex = static_cast<std::size_t>(mesh.triangles[i][k]);
      base::require(vertex < mesh.vertices.size(), "a triangle names a vertex that is not there");
      corners.at[k] = mesh.vertices[vertex];
      base::require(corners.at[k].allFinite(), "a vertex of the surface is not finite");
    }
    corners_.push_back(corners);
  }
  nodes_.reserve(2 * corners_.size() / kLeafSize + 1);
  build(0, corners_.size());
}

void TriangleTree::build(std::size_t begin, std::size_t end) {
  const std::size_t self = nodes_.size();
  Node node;
  node.low = node.high = corners_[begin].at[0];
  Vec3 centre_low = Vec3::Constant(1e300), centre_high = Vec3::Constant(-1e300);
  const auto centre = [](const Corners& c) { return Vec3(c.at[0] + c.at[1] + c.at[2]); };
  for (std::size_t i = begin; i < end; ++i) {
    for (const Vec3& corner : corners_[i].at) {
      node.low = node.low.cwiseMin(corner);
      node.high = node.high.cwiseMax(corner);
    }
    centre_low = centre_low.cwiseMin(centre(corners_[i]));
    centre_high = centre_high.cwiseMax(centre(corners_[i]));
  }
  nodes_.push_back(node);
  if (end - begin <= kLeafSize) {
    nodes_[self].first = static_cast<std::int32_t>(begin);
    nodes_[self].count = static_cast<std::int32_t>(end - begin);
    return;
  }
  // halve across the widest extent of the centres; ties by index, so that the tree is the same
  // wherever it is built
  Eigen::Index axis = 0;
  (centre_high - centre_low).maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [this](std::size_t i) {
    return corners_.begin() + static_cast<std::ptrdiff_t>(i);
  };
  std::nth_element(at(begin), at(middle), at(end), [&](const Corners& a, const Corners& b) {
    return std::pair(centre(a)[axis], a.triangle) < std::pair(centre(b)[axis], b.triangle);
  });
  build(begin, middle);
  nodes_[self].first = static_cast<std::int32_t>(nodes_.size());
  build(middle, end);
}

NearestTriangle TriangleTree::nearest(const Vec3& point, double bound) const {
  NearestTriangle best;
  best.squared_distance = bound * bound;
  search(point, best);
  return best;
}

NearestTriangle TriangleTree::nearest(const Vec3& point, const NearestTriangle& close_by) const {
  NearestTriangle best;
  if (close_by.slot >= 0) try_triangle(point, static_cast<std::size_t>(close_by.slot), best);
  search(point, best);
  return best;
}

void TriangleTree::try_triangle(const Vec3& point, std::size_t slot, NearestTriangle& best) const {
  const Corners& corners = corners_[slot];
  // seen along the way to its middle, all corners lie behind the best distance: so does it all
  const Vec3 a = corners.at[0] - point, b = corners.at[1] - point, c = corners.at[2] - point;
  const Vec3 to_middle = a + b + c;
  const double nearest_corner = std::min({a.dot(to_middle), b.dot(to_middle), c.dot(to_middle)});
  if (nearest_corner > 0.0 &&
      nearest_corner * nearest_corner >= best.squared_distance * to_middle.squaredNorm()) {
    return;
  }
  const TrianglePoint found =
      nearest_on_triangle(point, corners.at[0], corners.at[1], corners.at[2]);
  if (found.squared_distance >= best.squared_distance) return;
  static_cast<TrianglePoint&>(best) = found;
  best.triangle = corners.triangle;
  best.slot = static_cast<std::int32_t>(slot);
}

void TriangleTree::search(const Vec3& point, NearestTriangle& best) const {
  struct Entry {
    std::size_t node;
    double squared_distance;
  };
  std::array<Entry, 64> stack;  // deeper than any halving of 2^31 triangles
  std::size_t depth = 0;
  const auto box_distance = [&](std::size_t i) {
    return squared_distance_to_box(point, nodes_[i].low, nodes_[i].high);
  };
  stack[depth++] = {0, box_distance(0)};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (entry.squared_distance >= best.squared_distance) continue;
    const Node& node = nodes_[entry.node];
    if (node.count == 0) {
      Entry near{entry.node + 1, box_distance(entry.node + 1)};
      Entry far{static_cast<std::size_t>(node.first),
                box_distance(static_cast<std::size_t>(node.first))};
      if (far.squared_distance < near.squared_distance) std::swap(near, far);
      assert(depth + 2 <= stack.size());
      if (far.squared_distance < best.squared_distance) stack[depth++] = far;
      if (near.squared_distance < best.squared_distance) stack[depth++] = near;
      continue;
    }
    for (std::int32_t slot = node.first; slot < node.first + node.count; ++slot) {
      try_triangle(point, static_cast<std::size_t>(slot), best);
    }
  }
}

}  // namespace sim
