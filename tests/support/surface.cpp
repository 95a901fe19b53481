#include "tests/support/surface.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace support {

using sim::TriangleMesh;
using sim::Vec3;

namespace {

using Edge = std::pair<std::int32_t, std::int32_t>;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

std::map<Edge, int> directed_edges(const TriangleMesh& mesh) {
  std::map<Edge, int> edges;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{triangle[k], triangle[(k + 1) % 3]}];
  }
  return edges;
}

}  // namespace

bool every_edge_is_shared_by_two(const TriangleMesh& mesh) {
  const auto edges = directed_edges(mesh);
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || edge.first == edge.second || back == edges.end()) return false;
  }
  return true;
}

bool every_vertex_has_one_fan(const TriangleMesh& mesh) {
  // around a vertex: from the neighbour a triangle starts with to the one it ends with
  std::vector<std::map<std::int32_t, std::int32_t>> next(mesh.vertices.size());
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      next[at(triangle[k])][triangle[(k + 1) % 3]] = triangle[(k + 2) % 3];
    }
  }
  for (const auto& around : next) {
    if (around.empty()) return false;
    std::size_t steps = 0;
    std::int32_t neighbour = around.begin()->first;
    do {
      const auto found = around.find(neighbour);
      if (found == around.end() || ++steps > around.size()) return false;
      neighbour = found->second;
    } while (neighbour != around.begin()->first);
    if (steps != around.size()) return false;
  }
  return true;
}

long euler_characteristic(const TriangleMesh& mesh) {
  std::set<Edge> edges;
  for (const auto& [edge, count] : directed_edges(mesh))
    edges.insert(std::minmax(edge.first, edge.second));
  return static_cast<long>(mesh.vertices.size()) - static_cast<long>(edges.size()) +
         static_cast<long>(mesh.triangles.size());
}

int shell_count(const TriangleMesh& mesh) {
  std::vector<std::size_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&parent](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& triangle : mesh.triangles) {
    parent[root(at(triangle[0]))] = root(at(triangle[1]));
    parent[root(at(triangle[1]))] = root(at(triangle[2]));
  }
  int shells = 0;
  for (std::size_t i = 0; i < parent.size(); ++i) shells += root(i) == i;
  return shells;
}

double enclosed_volume(const TriangleMesh& mesh) {
  double six_times = 0.0;
  for (const auto& triangle : mesh.triangles) {
    six_times += mesh.vertices[at(triangle[0])].dot(
        mesh.vertices[at(triangle[1])].cross(mesh.vertices[at(triangle[2])]));
  }
  return six_times / 6.0;
}

double winding_number(const TriangleMesh& mesh, const Vec3& point) {
  double angle = 0.0;
  for (const auto& triangle : mesh.triangles) {
    const Vec3 a = mesh.vertices[at(triangle[0])] - point;
    const Vec3 b = mesh.vertices[at(triangle[1])] - point;
    const Vec3 c = mesh.vertices[at(triangle[2])] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2.0 * std::atan2(a.dot(b.cross(c)),
                              la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4.0 * std::numbers::pi);
}

}  // namespace support
