// A wire bent at rest, turned at its base inside a tight smooth tube of constant curvature: a
// pendulum along the wire. With psi the angle between the wire's own bend and the tube's, lengths
// in units of L, and a = L^2 EI kappa_wire kappa_tube / GJ:
//
//   psi'' = a sin(psi),   psi(0) = the base's angle,   psi'(1) = 0 at the tip
//
// From a = (pi / 2)^2 on the tip does not follow: it lags, and then whips around.
#pragma once

#include <optional>

namespace sim::validation {

// The base's angle that goes with a tip's angle, rad.
double base_angle(double a, double tip_angle);

// The largest base angle of the branch that starts at rest, where the tip whips around; none when
// it follows all the way.
std::optional<double> whip_angle(double a);

}  // namespace sim::validation
