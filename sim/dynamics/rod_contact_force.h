// The contact force, one definition for gauges, limits, hits, perforation and metrics: the largest
// norm of the vector sum of wall reactions over any 6 mm of the instrument's length.
#pragma once

#include <span>

#include "sim/math/vec3.h"

namespace sim {

inline constexpr double kContactWindow = 6.0;  // mm

// `forces`: the wall's reaction on each node, N. `cells`: the length each node stands for, mm, in
// the same order along the instrument; a node's force is taken as spread evenly over its cell, so
// that the answer does not depend on the mesh. Allocates nothing.
double largest_contact_force(std::span<const Vec3> forces, std::span<const double> cells);

}  // namespace sim
