// How a surface crosses one cell of a volume, for each of the 256 ways its corners can lie inside
// or outside. Derived by rule, not typed in: the surface it gives is closed and 2-manifold for
// every volume.
//
// Corner c of a cell lies at (c & 1, c >> 1 & 1, c >> 2 & 1). Edge e = 4 * axis + k runs along
// `axis` from the corner whose two other coordinates are the bits of k, lower axis first.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace sim {

// The two corners of a cell edge, the lower first.
struct CellEdge {
  int from = 0, to = 0;
  int axis = 0;
};
const std::array<CellEdge, 12>& cell_edges();

// Triangles as triples of cell edges, counter-clockwise seen from outside.
using CellTriangles = std::vector<std::array<std::int8_t, 3>>;

// Indexed by the mask of inside corners (bit c set: corner c is inside).
const std::array<CellTriangles, 256>& cell_cases();

}  // namespace sim
