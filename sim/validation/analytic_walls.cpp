#include "sim/validation/analytic_walls.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "sim/base/require.h"

namespace sim {

CylinderWall::CylinderWall(const Vec3& point, const Vec3& axis, double radius)
    : point_(point), axis_(axis.normalized()), radius_(radius) {
  base::require(radius > 0.0 && axis.norm() > 0.0, "a cylinder needs a radius and an axis");
}

void CylinderWall::sample(std::span<const Vec3> points, std::span<WallSample> samples) const {
  assert(points.size() == samples.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 offset = points[i] - point_;
    const Vec3 radial = offset - offset.dot(axis_) * axis_;
    const double distance = radial.norm();
    samples[i].distance = distance - radius_;
    samples[i].normal = distance > 1e-12 ? Vec3(radial / distance) : axis_.unitOrthogonal();
  }
}

PlaneWall::PlaneWall(const Vec3& point, const Vec3& normal)
    : point_(point), normal_(normal.normalized()) {
  base::require(normal.norm() > 0.0, "a plane needs a normal");
}

void PlaneWall::sample(std::span<const Vec3> points, std::span<WallSample> samples) const {
  assert(points.size() == samples.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    samples[i] = {.distance = (points[i] - point_).dot(normal_), .normal = normal_};
  }
}

TubeWall::TubeWall(double radius, const Vec3& start, const Vec3& direction, const Vec3& up)
    : radius_(radius),
      position_(start),
      direction_(direction.normalized()),
      up_((up - up.dot(direction_) * direction_).normalized()) {
  base::require(radius > 0.0, "a tube needs a positive radius");
}

void TubeWall::add_straight(double length) {
  base::require(length > 0.0, "a stretch needs a positive length");
  Piece piece;
  piece.start = position_;
  piece.direction = direction_;
  piece.length = length;
  position_ += length * direction_;
  piece.end = position_;
  length_ += length;
  pieces_.push_back(piece);
}

void TubeWall::add_bend(double bend_radius, double angle) {
  base::require(bend_radius > radius_, "a bend must be wider than its tube");
  base::require(angle != 0.0 && std::abs(angle) <= std::numbers::pi, "a bend turns up to pi");
  const Vec3 inward = angle > 0.0 ? up_ : Vec3(-up_);
  const double size = std::abs(angle);
  Piece piece;
  piece.bend = true;
  piece.start = position_;
  piece.centre = position_ + bend_radius * inward;
  piece.radial = -inward;
  piece.forward = direction_;
  piece.bend_radius = bend_radius;
  piece.length = bend_radius * size;
  const Vec3 last_radial = std::cos(size) * piece.radial + std::sin(size) * piece.forward;
  const Vec3 last_forward = std::cos(size) * piece.forward - std::sin(size) * piece.radial;
  piece.last_normal = last_forward;
  position_ = piece.centre + bend_radius * last_radial;
  piece.end = position_;
  up_ = angle > 0.0 ? Vec3(-last_radial) : last_radial;
  direction_ = last_forward;
  length_ += bend_radius * size;
  pieces_.push_back(piece);
}

std::vector<Vec3> TubeWall::axis(double spacing) const {
  std::vector<Vec3> points;
  for (const Piece& piece : pieces_) {
    const auto count = static_cast<int>(std::ceil(piece.length / spacing));
    for (int i = 0; i < count; ++i) {
      const double along = piece.length * i / count;
      const double angle = piece.bend ? along / piece.bend_radius : 0.0;
      points.push_back(
          piece.bend ? Vec3(piece.centre + piece.bend_radius * (std::cos(angle) * piece.radial +
                                                                std::sin(angle) * piece.forward))
                     : Vec3(piece.start + along * piece.direction));
    }
  }
  points.push_back(position_);
  return points;
}

Vec3 TubeWall::nearest_on_axis(const Vec3& point) const {
  Vec3 nearest = Vec3::Zero();
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const Vec3& candidate) {
    const double distance = (point - candidate).squaredNorm();
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  };
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const Piece& piece = pieces_[k];
    if (!piece.bend) {
      double along = (point - piece.start).dot(piece.direction);
      if (k > 0) along = std::max(along, 0.0);
      if (k + 1 < pieces_.size()) along = std::min(along, piece.length);
      consider(piece.start + along * piece.direction);
      continue;
    }
    const Vec3 offset = point - piece.centre;
    const double u = offset.dot(piece.radial);
    const double v = offset.dot(piece.forward);
    const double size = std::sqrt(u * u + v * v);
    const bool within = v >= 0.0 && offset.dot(piece.last_normal) <= 0.0;
    if (within && size > 1e-12) {
      consider(piece.centre + piece.bend_radius / size * (u * piece.radial + v * piece.forward));
    } else {
      consider(piece.start);
      consider(piece.end);
    }
  }
  return nearest;
}

void TubeWall::sample(std::span<const Vec3> points, std::span<WallSample> samples) const {
  assert(points.size() == samples.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 inward = nearest_on_axis(points[i]) - points[i];
    const double distance = inward.norm();
    samples[i].distance = radius_ - distance;
    samples[i].normal = distance > 1e-12 ? Vec3(inward / distance) : up_;
  }
}

}  // namespace sim
