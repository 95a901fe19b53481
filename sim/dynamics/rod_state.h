// What moves: nodes, twist angles, and the frames they are measured from. Numbered from the tip.
//
// Each edge carries a reference direction normal to it that is carried along in time without
// turning about the edge (parallel transport); the twist angle of the edge's material is measured
// from it, right-handed about the edge's tangent (which points from the tip to the base).
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include "sim/math/vec3.h"

namespace sim {

// One value per node or edge and coordinate. Apart, so that loops over all nodes vectorise.
struct Vec3Array {
  std::vector<double> x, y, z;

  void resize(std::size_t size) {
    x.assign(size, 0.0);
    y.assign(size, 0.0);
    z.assign(size, 0.0);
  }
  Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const Vec3& value) {
    x[i] = value.x();
    y[i] = value.y();
    z[i] = value.z();
  }
};

struct RodState {
  std::size_t node_count = 0;  // the nodes in use; arrays are sized for the whole instrument
  Vec3Array position;          // mm, per node
  Vec3Array velocity;          // mm/s, per node
  std::vector<double> twist;   // rad, per edge
  std::vector<double> twist_rate;
  Vec3Array tangent;    // unit, per edge, for which `reference` was last transported
  Vec3Array reference;  // unit, normal to the tangent, per edge
  // Angle from the reference of the previous edge, transported along the rod, to this edge's, per
  // node. Kept as a running sum, so that several turns survive; cosine and sine beside it.
  std::vector<double> reference_twist;
  std::vector<double> reference_cosine;
  std::vector<double> reference_sine;
  Vec3Array bristle;  // mm, per node: elastic slip of the surface against the wall

  explicit RodState(std::size_t capacity) {
    for (Vec3Array* array : {&position, &velocity, &tangent, &reference, &bristle}) {
      array->resize(capacity);
    }
    for (std::vector<double>* array :
         {&twist, &twist_rate, &reference_twist, &reference_cosine, &reference_sine}) {
      array->assign(capacity, 0.0);
    }
  }
};

// Appends the state in use, byte by byte.
inline void append_bytes(const RodState& state, std::vector<std::byte>& bytes) {
  const auto append = [&bytes](const double* values, std::size_t count) {
    const auto raw = std::as_bytes(std::span<const double>(values, count));
    bytes.insert(bytes.end(), raw.begin(), raw.end());
  };
  const std::size_t nodes = state.node_count;
  for (const Vec3Array* array :
       {&state.position, &state.velocity, &state.tangent, &state.reference, &state.bristle}) {
    append(array->x.data(), nodes);
    append(array->y.data(), nodes);
    append(array->z.data(), nodes);
  }
  for (const std::vector<double>* array : {&state.twist, &state.twist_rate, &state.reference_twist,
                                           &state.reference_cosine, &state.reference_sine}) {
    append(array->data(), nodes);
  }
}

}  // namespace sim
