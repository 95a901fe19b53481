#include "sim/anatomy/tube_axis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "sim/base/require.h"

namespace sim {
namespace {

void check(const TubeDescription& tube) {
  base::require(!tube.legs.empty(), "a tube needs at least one leg");
  base::require(std::isfinite(tube.start_radius) && tube.start_radius > 0.0,
                "the radius of a tube must be positive");
  base::require(
      tube.access.allFinite() && tube.direction.allFinite() && tube.direction.norm() > 1e-9,
      "a tube needs a finite access and a direction");
  double radius = tube.start_radius;
  for (const TubeLeg& leg : tube.legs) {
    base::require(std::isfinite(leg.length) && leg.length > 0.0,
                  "the length of a leg must be positive");
    base::require(std::isfinite(leg.end_radius) && leg.end_radius > 0.0,
                  "the radius of a tube must be positive");
    base::require(std::isfinite(leg.bend) && std::isfinite(leg.plane),
                  "the angles of a leg must be finite");
    base::require(
        std::abs(leg.bend) * std::max(radius, leg.end_radius) < leg.length,
        "a leg bends with less radius than its lumen has: make it longer or bend it less");
    radius = leg.end_radius;
  }
}

// The coordinate axis least along `direction`, made normal to it.
Vec3 any_normal(const Vec3& direction) {
  Eigen::Index least = 0;
  direction.cwiseAbs().minCoeff(&least);
  const Vec3 axis = Vec3::Unit(least);
  return (axis - axis.dot(direction) * direction).normalized();
}

// Where the chain of pieces has got to; `up` is carried along without twisting.
struct Frame {
  Vec3 position, tangent, up;
};

void append_leg(const Frame& at, const TubeLeg& leg, double radius_in, double longest,
                TubeAxis& axis, double& arc, Frame& end) {
  Vec3 side = std::cos(leg.plane) * at.up + std::sin(leg.plane) * at.tangent.cross(at.up);
  if (leg.bend < 0.0) side = -side;
  AxisPiece whole{
      at.position, at.tangent, side,      leg.length,    std::abs(leg.bend) / leg.length,
      0.0,         leg.length, radius_in, leg.end_radius};

  const int count = std::max(1, static_cast<int>(std::ceil(leg.length / longest)));
  const double piece_length = leg.length / count;
  for (int i = 0; i < count; ++i) {
    AxisPiece piece = whole;
    const double s = i * piece_length;
    piece.start = whole.point(s);
    piece.tangent = whole.direction(s);
    piece.side = std::cos(whole.curvature * s) * side - std::sin(whole.curvature * s) * at.tangent;
    piece.length = piece_length;
    piece.leg_start = s;
    axis.pieces.push_back(piece);
    axis.piece_start.push_back(arc + s);
  }
  arc += leg.length;
  const Vec3 turn_axis = at.tangent.cross(side);
  end = {whole.point(leg.length), whole.direction(leg.length).normalized(),
         Eigen::AngleAxisd(std::abs(leg.bend), turn_axis) * at.up};
  end.up = (end.up - end.up.dot(end.tangent) * end.tangent).normalized();
}

}  // namespace

Vec3 AxisPiece::point(double s) const {
  const double angle = curvature * s;
  if (angle < 1e-9) return start + s * tangent;
  return start + (std::sin(angle) * tangent + (1.0 - std::cos(angle)) * side) / curvature;
}

Vec3 AxisPiece::direction(double s) const {
  return std::cos(curvature * s) * tangent + std::sin(curvature * s) * side;
}

double AxisPiece::radius(double s) const {
  const double t = std::clamp((leg_start + s) / leg_length, 0.0, 1.0);
  return leg_radius_in + (leg_radius_out - leg_radius_in) * t * t * (3.0 - 2.0 * t);
}

double AxisPiece::nearest(const Vec3& p) const {
  const Vec3 from_start = p - start;
  if (curvature * length < 1e-9) return std::clamp(from_start.dot(tangent), 0.0, length);
  // the angle about the centre, measured from the middle so that it is cut open at the far side
  const Vec3 from_centre = from_start - side / curvature;
  const double angle = std::atan2(from_centre.dot(tangent), -from_centre.dot(side));
  const double half = curvature * length / 2.0;
  const double from_middle = std::remainder(angle - half, 2.0 * std::numbers::pi);
  return (std::clamp(from_middle, -half, half) + half) / curvature;
}

TubeAxis tube_axis(const TubeDescription& tube, double longest) {
  check(tube);
  base::require(longest > 0.0, "the step along a tube must be positive");
  TubeAxis axis;
  axis.direction = tube.direction.normalized();
  axis.up = any_normal(axis.direction);
  axis.smallest_radius = tube.start_radius;

  Frame at{tube.access - kSheathOverhang * axis.direction, axis.direction, axis.up};
  double arc = -kSheathOverhang;
  double radius = tube.start_radius;
  const auto add = [&](const TubeLeg& leg) {
    Frame end;
    append_leg(at, leg, radius, longest, axis, arc, end);
    at = end;
    radius = leg.end_radius;
    axis.smallest_radius = std::min(axis.smallest_radius, radius);
  };
  add({kSheathOverhang, 0.0, 0.0, radius});
  arc = 0.0;  // exactly
  for (const TubeLeg& leg : tube.legs) add(leg);
  return axis;
}

}  // namespace sim
