// An instrument cut into nodes and edges, with the stiffness each of them stands for. Fixed for
// the instrument's life: nodes are points of the material, found by arc length from the tip.
//
//   tip  0 --edge 0-- 1 --edge 1-- 2 ...  n-1  back
//
// A node stands for its cell, half of each edge beside it. Stiffness is averaged over the cell
// (the compliance, which is what adds up along a beam), so nothing jumps where sections meet.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/instrument/instrument.h"

namespace sim {

struct RodMesh {
  std::vector<double> arc;          // mm from the tip, per node
  std::vector<double> cell_length;  // mm, per node
  std::vector<double> edge_length;  // mm, per edge, at rest
  std::vector<double> bending;      // EI / cell length, N mm, per node; 0 at both ends
  std::vector<double> twisting;     // GJ / cell length, N mm, per node; 0 at both ends
  // 2 tan(angle / 2) of the angle by which the resting rod bends at the node, in its own plane.
  std::vector<double> rest_bend;
  double radius = 0.0;    // mm
  double friction = 0.0;  // Coulomb coefficient

  std::size_t node_count() const { return arc.size(); }
};

struct RodMeshSizes {
  double element_length = 3.0;      // mm
  double tip_element_length = 2.0;  // mm
  double tip_mesh_length = 40.0;    // mm with the tip's element length; grows to hold all bends
  double extension = 0.0;           // mm of further material behind the instrument's end
};

// Throws std::invalid_argument when the instrument or the sizes make no sense.
RodMesh make_rod_mesh(const Instrument& instrument, const RodMeshSizes& sizes);

}  // namespace sim
