// The axis of a tube as a chain of exact straight and circular pieces, and the function whose
// zero is the tube's wall. Also what the analytic side of a test measures against.
#pragma once

#include <vector>

#include "sim/anatomy/tube.h"
#include "sim/math/vec3.h"

namespace sim {

// A short piece of constant curvature. `side` is the unit normal it bends towards.
struct AxisPiece {
  Vec3 start = Vec3::Zero(), tangent = Vec3::UnitZ(), side = Vec3::UnitX();
  double length = 0.0;
  double curvature = 0.0;                            // 1/mm, >= 0
  double leg_start = 0.0, leg_length = 0.0;          // mm: where in its leg the piece starts
  double leg_radius_in = 0.0, leg_radius_out = 0.0;  // mm: radius at the leg's two ends

  Vec3 point(double s) const;           // s in [0, length]
  Vec3 direction(double s) const;       // unit
  double radius(double s) const;        // of the lumen
  double nearest(const Vec3& p) const;  // the s whose point is nearest
};

// Pieces no longer than `longest`, the overhang behind the access first. `up` returns the normal
// of the frame at the access. Throws std::invalid_argument as tube_centreline does.
struct TubeAxis {
  std::vector<AxisPiece> pieces;
  std::vector<double> piece_start;  // arc length from the access; negative in the overhang
  Vec3 direction = Vec3::UnitZ(), up = Vec3::UnitX();
  double smallest_radius = 0.0;
};
TubeAxis tube_axis(const TubeDescription& tube, double longest);

}  // namespace sim
