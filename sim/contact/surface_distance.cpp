#include "sim/contact/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <Eigen/Geometry>

#include "sim/base/require.h"

namespace sim {
namespace {

// Vertex normals further than this from the facet mean a crease, not a curve.
constexpr double kCreaseCosine = 0.8;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

Vec3 unit_or(const Vec3& vector, const Vec3& otherwise) {
  const double length = vector.norm();
  return length > 1e-300 ? Vec3(vector / length) : otherwise;
}

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// A directed edge and where it belongs.
struct DirectedEdge {
  std::int32_t low, high;  // its vertices
  std::int32_t triangle;
  std::int32_t opposite;  // the corner that is not on it
  bool forward;           // runs from low to high
};

std::vector<DirectedEdge> sorted_edges(const TriangleMesh& mesh) {
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::int32_t k = 0; k < 3; ++k) {
      const std::int32_t from = mesh.triangles[t][at((k + 1) % 3)];
      const std::int32_t to = mesh.triangles[t][at((k + 2) % 3)];
      edges.push_back(
          {std::min(from, to), std::max(from, to), static_cast<std::int32_t>(t), k, from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const DirectedEdge& a, const DirectedEdge& b) {
    return std::array{a.low, a.high, a.triangle, a.opposite} <
           std::array{b.low, b.high, b.triangle, b.opposite};
  });
  return edges;
}

}  // namespace

SurfaceDistance::SurfaceDistance(const TriangleMesh& mesh) : mesh_(mesh), tree_(mesh) {
  // facets, and the corners' normals weighted by the angle each facet takes there
  // (Baerentzen and Aanaes 2005: the weighting that gives the side right at a corner)
  facet_normals_.reserve(mesh.triangles.size());
  corner_normals_.assign(mesh.vertices.size(), Vec3::Zero());
  for (const auto& triangle : mesh.triangles) {
    const std::array<Vec3, 3> corner{mesh.vertices[at(triangle[0])], mesh.vertices[at(triangle[1])],
                                     mesh.vertices[at(triangle[2])]};
    const Vec3 normal = unit_or((corner[1] - corner[0]).cross(corner[2] - corner[0]), Vec3::Zero());
    facet_normals_.push_back(normal);
    for (std::size_t k = 0; k < 3; ++k) {
      const double angle =
          angle_between(corner[(k + 1) % 3] - corner[k], corner[(k + 2) % 3] - corner[k]);
      corner_normals_[at(triangle[k])] += angle * normal;
    }
  }

  // edges: the sum over the two facets that share each
  edge_normals_.resize(mesh.triangles.size());
  const std::vector<DirectedEdge> edges = sorted_edges(mesh);
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    Vec3 sum = Vec3::Zero();
    int balance = 0;
    for (; end < edges.size() && edges[end].low == edges[begin].low &&
           edges[end].high == edges[begin].high;
         ++end) {
      sum += facet_normals_[at(edges[end].triangle)];
      balance += edges[end].forward ? 1 : -1;
    }
    base::require(balance == 0 && end - begin >= 2,
                  "the surface must be closed and consistently oriented");
    for (std::size_t i = begin; i < end; ++i) {
      edge_normals_[at(edges[i].triangle)][at(edges[i].opposite)] = sum;
    }
  }

  if (mesh.normals.size() == mesh.vertices.size()) {
    normals_ = mesh.normals;
  } else {
    for (const Vec3& sum : corner_normals_) normals_.push_back(unit_or(sum, Vec3::Zero()));
  }
  curved_.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    bool smooth = true;
    for (const std::int32_t vertex : mesh.triangles[t]) {
      smooth = smooth && normals_[at(vertex)].dot(facet_normals_[t]) > kCreaseCosine;
    }
    curved_.push_back(smooth ? 1 : 0);
  }
}

// +1 inside, -1 outside, by the normal of what the nearest point lies on.
double SurfaceDistance::side(const Vec3& point, const NearestTriangle& nearest) const {
  const std::size_t t = at(nearest.triangle);
  const Eigen::Index on = (nearest.weights.array() > 0.0).count();
  Vec3 outward = facet_normals_[t];
  Eigen::Index k = 0;
  if (on == 2) {
    nearest.weights.minCoeff(&k);
    outward = edge_normals_[t][static_cast<std::size_t>(k)];
  } else if (on == 1) {
    nearest.weights.maxCoeff(&k);
    outward = corner_normals_[at(mesh_.triangles[t][static_cast<std::size_t>(k)])];
  }
  return (point - nearest.position).dot(outward) > 0.0 ? -1.0 : 1.0;
}

WallSample SurfaceDistance::sample(const Vec3& point, NearestTriangle& close_by) const {
  const NearestTriangle nearest = tree_.nearest(point, close_by);
  close_by = nearest;
  const std::size_t t = at(nearest.triangle);
  WallSample flat;
  flat.distance = side(point, nearest) * std::sqrt(nearest.squared_distance);
  flat.normal = std::abs(flat.distance) > 1e-9 ? Vec3((point - nearest.position) / flat.distance)
                                               : Vec3(-facet_normals_[t]);
  if (curved_[t] == 0) return flat;

  // the patch: halfway between the flat point and its projections on the tangent planes at the
  // corners, which is where a circle through both ends of an edge passes
  Vec3 normal = Vec3::Zero(), lift = Vec3::Zero();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const std::size_t vertex = at(mesh_.triangles[t][static_cast<std::size_t>(k)]);
    const double height = (mesh_.vertices[vertex] - nearest.position).dot(normals_[vertex]);
    lift += nearest.weights[k] * height * normals_[vertex];
    normal += nearest.weights[k] * normals_[vertex];
  }
  const Vec3 inward = -unit_or(normal, facet_normals_[t]);
  const Vec3 on_patch = nearest.position + 0.5 * lift;
  WallSample smooth;
  smooth.distance = (point - on_patch).dot(inward);
  smooth.normal = inward;
  // far from the wall and near a crease the nearest point is no foot on this patch
  const bool agrees = std::abs(smooth.distance - flat.distance) <
                      0.5 * lift.norm() + 0.05 * std::abs(flat.distance) + 1e-6;
  return agrees ? smooth : flat;
}

double SurfaceDistance::facet_distance(const Vec3& point) const {
  const NearestTriangle nearest = tree_.nearest(point);
  return side(point, nearest) * std::sqrt(nearest.squared_distance);
}

}  // namespace sim
