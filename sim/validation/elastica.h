// The planar elastica: a thin rod that bends but neither stretches nor shears, of any deflection.
// Solved as the ordinary differential equation of the continuum, by Runge-Kutta and shooting: an
// answer that has nothing in common with the rod solver.
//
//   theta' = kappa_0(s) + M / EI,   M' = F_x sin(theta) - F_y cos(theta),
//   x' = cos(theta),   y' = sin(theta)
//
// clamped along x at s = 0, a dead force F at s = length, where M = 0.
#pragma once

#include <numbers>
#include <utility>
#include <vector>

namespace sim::validation {

struct Elastica {
  double x = 0.0;          // mm, of the end
  double y = 0.0;          // mm
  double angle = 0.0;      // rad, of the end
  double lowest_y = 0.0;   // mm, of any point
  double highest_y = 0.0;  // mm
};

// A straight cantilever under a dead load P at its end, `direction` (rad, 0 < direction < pi) being
// the angle from +x, along which the rod points at rest; pi / 2 is Bisshopp and Drucker 1945. Of
// the equilibria the one that bends one way only, any P >= 0.
Elastica loaded_cantilever(double length, double bending_stiffness, double load,
                           double direction = std::numbers::pi / 2.0);
// The same rod's points (x, y) at `intervals` + 1 equal distances along it, from the clamp.
std::vector<std::pair<double, double>> loaded_cantilever_shape(double length,
                                                               double bending_stiffness,
                                                               double load, double direction,
                                                               int intervals);

// A cantilever whose last `bend_length` has the rest curvature `curvature` (1/mm, towards +y),
// straight before that, under the end force F along +y. For moderate loads.
Elastica bent_cantilever(double length, double bending_stiffness, double bend_length,
                         double curvature, double force);

// Buckled rod with pinned ends, shortened to (1 - shortening) of its length: its end force over
// Euler's pi^2 EI / L^2, and the deflection of its middle over L. 0 < shortening < 0.5.
struct BuckledRod {
  double load_ratio = 0.0;
  double deflection_ratio = 0.0;
};
BuckledRod buckled_rod(double shortening);

}  // namespace sim::validation
