#include "sim/anatomy/cell_cases.h"

#include <cassert>
#include <limits>

#include "sim/math/vec3.h"

namespace sim {
namespace {

constexpr int kNone = -1;

int edge_between(int corner_a, int corner_b) {
  const auto& edges = cell_edges();
  for (int e = 0; e < 12; ++e) {
    const CellEdge& edge = edges[static_cast<std::size_t>(e)];
    if ((edge.from == corner_a && edge.to == corner_b) ||
        (edge.from == corner_b && edge.to == corner_a)) {
      return e;
    }
  }
  return kNone;
}

// Corners of each face in order, counter-clockwise seen from outside the cell.
std::array<std::array<int, 4>, 6> face_corners() {
  std::array<std::array<int, 4>, 6> faces{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int u = 1 << ((axis + 1) % 3);
    const int v = 1 << ((axis + 2) % 3);
    const int high = 1 << axis;
    faces[2 * axis] = {0, v, u | v, u};
    faces[2 * axis + 1] = {high, high | u, high | u | v, high | v};
  }
  return faces;
}

// True if one face of the cell holds both edges.
bool on_common_face(int edge_a, int edge_b) {
  const CellEdge& a = cell_edges()[static_cast<std::size_t>(edge_a)];
  const CellEdge& b = cell_edges()[static_cast<std::size_t>(edge_b)];
  const int all_set = a.from & a.to & b.from & b.to;
  const int all_clear = ~(a.from | a.to | b.from | b.to) & 7;
  return all_set != 0 || all_clear != 0;
}

// For each crossed edge the crossed edge that follows it around the surface.
//
// On every face each run of inside corners is cut off by one segment, so that on an ambiguous face
// (two inside corners across a diagonal) the inside corners are separated. The rule looks at this
// face's corners only: the cell on the other side draws the same segments, in the other direction.
// Each crossed edge then starts one segment and ends one, and the segments close to loops.
std::array<int, 12> surface_segments(int mask) {
  std::array<int, 12> next{};
  next.fill(kNone);
  const auto inside = [mask](int corner) { return ((mask >> corner) & 1) != 0; };
  for (const auto& face : face_corners()) {
    for (std::size_t start = 0; start < 4; ++start) {
      const int before = face[(start + 3) % 4];
      if (!inside(face[start]) || inside(before)) continue;
      std::size_t last = start;  // the run of inside corners ends here
      while (inside(face[(last + 1) % 4])) ++last;
      const int entry = edge_between(before, face[start]);
      const int exit = edge_between(face[last % 4], face[(last + 1) % 4]);
      next[static_cast<std::size_t>(entry)] = exit;
    }
  }
  return next;
}

Vec3 edge_middle(int e) {
  const CellEdge& edge = cell_edges()[static_cast<std::size_t>(e)];
  const auto corner = [](int c) { return Vec3(c & 1, (c >> 1) & 1, (c >> 2) & 1); };
  return (corner(edge.from) + corner(edge.to)) / 2.0;
}

// Cuts a loop into triangles so that no cut joins two edges of one face: the neighbour behind that
// face could make the same cut, and four triangles would meet in it. Among what is left, short
// cuts. (The classical minimum over all cuts of a polygon, by intervals.)
class LoopTriangulation {
 public:
  explicit LoopTriangulation(const std::vector<int>& loop) : loop_(loop) {}

  void append_to(CellTriangles& triangles) {
    const double cost = solve(0, loop_.size() - 1);
    assert(cost < kForbidden && "every loop of a cell can be cut without touching a face");
    (void)cost;
    collect(0, loop_.size() - 1, triangles);
  }

 private:
  static constexpr double kForbidden = 1e6;

  double cut_cost(std::size_t i, std::size_t j) const {
    const bool side = j == i + 1 || (i == 0 && j + 1 == loop_.size());
    if (side) return 0.0;
    if (on_common_face(loop_[i], loop_[j])) return kForbidden;
    return (edge_middle(loop_[i]) - edge_middle(loop_[j])).squaredNorm();
  }

  double solve(std::size_t i, std::size_t j) {
    if (j == i + 1) return 0.0;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t m = i + 1; m < j; ++m) {
      const double cost = cut_cost(i, m) + cut_cost(m, j) + solve(i, m) + solve(m, j);
      if (cost < best) {
        best = cost;
        apex_[i][j] = m;
      }
    }
    return best;
  }

  void collect(std::size_t i, std::size_t j, CellTriangles& triangles) const {
    if (j == i + 1) return;
    const std::size_t m = apex_[i][j];
    triangles.push_back({static_cast<std::int8_t>(loop_[i]), static_cast<std::int8_t>(loop_[m]),
                         static_cast<std::int8_t>(loop_[j])});
    collect(i, m, triangles);
    collect(m, j, triangles);
  }

  const std::vector<int>& loop_;
  std::array<std::array<std::size_t, 12>, 12> apex_{};
};

CellTriangles triangles_of(int mask) {
  CellTriangles triangles;
  std::array<int, 12> next = surface_segments(mask);
  for (std::size_t first = 0; first < 12; ++first) {
    std::vector<int> loop;
    for (std::size_t e = first; next[e] != kNone;) {
      loop.push_back(static_cast<int>(e));
      const auto following = static_cast<std::size_t>(next[e]);
      next[e] = kNone;  // taken
      e = following;
    }
    if (!loop.empty()) LoopTriangulation(loop).append_to(triangles);
  }
  return triangles;
}

}  // namespace

const std::array<CellEdge, 12>& cell_edges() {
  static const std::array<CellEdge, 12> edges = [] {
    std::array<CellEdge, 12> made{};
    std::size_t e = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const int low = axis == 0 ? 1 : 0;
      const int high = axis == 2 ? 1 : 2;
      for (int k = 0; k < 4; ++k) {
        const int from = ((k & 1) << low) | ((k >> 1) << high);
        made[e++] = {from, from | (1 << axis), axis};
      }
    }
    return made;
  }();
  return edges;
}

const std::array<CellTriangles, 256>& cell_cases() {
  static const std::array<CellTriangles, 256> cases = [] {
    std::array<CellTriangles, 256> made;
    for (int mask = 0; mask < 256; ++mask)
      made[static_cast<std::size_t>(mask)] = triangles_of(mask);
    return made;
  }();
  return cases;
}

}  // namespace sim
