// Walls given by formulas, for checking the mechanics without any mesh or grid in between.
#pragma once

#include <span>
#include <vector>

#include "sim/contact/wall.h"
#include "sim/math/vec3.h"

namespace sim {

// The outside of an endless round cylinder.
class CylinderWall final : public Wall {
 public:
  // Throws std::invalid_argument unless the radius is positive and the axis not zero.
  CylinderWall(const Vec3& point, const Vec3& axis, double radius);
  void sample(std::span<const Vec3> points, std::span<WallSample> samples) const override;

 private:
  Vec3 point_;
  Vec3 axis_;
  double radius_;  // mm
};

// A plane: the lumen is the side the normal points to.
class PlaneWall final : public Wall {
 public:
  PlaneWall(const Vec3& point, const Vec3& normal);
  void sample(std::span<const Vec3> points, std::span<WallSample> samples) const override;

 private:
  Vec3 point_;
  Vec3 normal_;
};

// The inside of a tube of constant radius around straight stretches and circular bends that
// continue each other smoothly. Open at both ends, where it continues as far as a point is.
class TubeWall final : public Wall {
 public:
  // The axis starts at `start` in `direction`; bends turn in the plane of direction and `up`.
  TubeWall(double radius, const Vec3& start, const Vec3& direction, const Vec3& up);

  void add_straight(double length);
  // Turns by `angle` (rad, 0 to pi, positive towards `up`) around a circle of `bend_radius`.
  void add_bend(double bend_radius, double angle);

  void sample(std::span<const Vec3> points, std::span<WallSample> samples) const override;

  double length() const { return length_; }      // mm, of the axis
  std::vector<Vec3> axis(double spacing) const;  // points on it from the start, mm apart
  Vec3 end() const { return position_; }

 private:
  struct Piece {
    bool bend = false;
    Vec3 start = Vec3::Zero(), end = Vec3::Zero(), direction = Vec3::Zero();
    double length = 0.0;
    Vec3 centre = Vec3::Zero(), radial = Vec3::Zero();  // a bend starts at centre + R radial
    Vec3 forward = Vec3::Zero(), last_normal = Vec3::Zero();
    double bend_radius = 0.0;
  };
  Vec3 nearest_on_axis(const Vec3& point) const;

  double radius_;
  Vec3 position_, direction_, up_;  // where the next piece starts
  double length_ = 0.0;
  std::vector<Piece> pieces_;
};

}  // namespace sim
