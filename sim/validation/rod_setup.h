// Rods as the validation cases need them: uniform, clamped at an exact place, at rest.
#pragma once

#include <functional>
#include <vector>

#include "sim/base/result.h"
#include "sim/dynamics/rod_settings.h"
#include "sim/dynamics/rod_solver.h"
#include "sim/instrument/instrument.h"
#include "sim/instrument/rod_mesh.h"
#include "sim/math/vec3.h"

namespace sim::validation {

// One section, no bends.
Instrument uniform_instrument(double length, double bending_stiffness, double twist_stiffness,
                              double outer_diameter, double friction);

// The instrument cut into `elements` equal ones, and one more behind its end to clamp it by: node
// `elements` is the clamp. Only the free half of the clamp's cell bends, so it is twice as stiff.
RodMesh clamped_mesh(const Instrument& instrument, int elements);

// Settings under which one step finds the equilibrium: a time step so long that inertia and drag
// vanish, a tolerance of 1e-6 of `force`, a stretch of one millionth under `force`.
RodSettings static_settings(double length, double bending_stiffness, double force);

// Nodes of a mesh on the x axis, its end (the clamp, if one element lies behind it) at the origin
// and the tip at x = length.
std::vector<Vec3> straight_nodes(const RodMesh& mesh, double length);

// The answer to a step that did not work out.
base::Error simulation_failed();

}  // namespace sim::validation
