// A straight rod under a torque between two clamps (Greenhill 1883): how much a force in its middle
// pushes it aside, and the torque at which it writhes. Exact for small deflections.
//
// With u = y + i z and lengths in units of L, forces in EI / L^2, torques in EI / L:
//
//   u'''' - i M u''' = P delta(1/2),   u = u' = 0 at both ends
#pragma once

#include <array>
#include <complex>
#include <optional>

namespace sim::validation {

// 2 x with tan(x) = x, in EI / L.
inline constexpr double kCriticalTorque = 8.98681891581813;

// The middle's deflection over that of the untwisted rod, P L^3 / (192 EI). 0 < torque < critical.
std::complex<double> twisted_rod_deflection(double torque);

// How far the middle yields under a torque.
struct TorqueResponse {
  double torque = 0.0, deflection = 0.0;
};
// M_c of deflection = A / (M_c^2 - M^2) + B through three responses of rising torque; none when
// they do not grow as that does.
std::optional<double> extrapolated_critical_torque(const TorqueResponse (&responses)[3]);

}  // namespace sim::validation
