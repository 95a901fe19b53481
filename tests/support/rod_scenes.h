// Scenes with rods in them, shared by tests and benchmarks. Walls are formulas, so that a scene
// is the same everywhere and what is measured is the rod.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "sim/anatomy/vessel.h"
#include "sim/dynamics/rod_instrument.h"
#include "sim/instrument/instrument.h"
#include "sim/math/vec3.h"
#include "sim/validation/analytic_walls.h"

namespace sim::scenes {

inline constexpr double kPi = std::numbers::pi;

// A straight wire of 0.035 inch, stiff (EI 2300 N mm^2) with a soft end (30).
inline Instrument stiff_wire(double length, double friction) {
  Instrument wire;
  wire.id = "stiff-wire";
  wire.outer_diameter = 0.889;
  wire.length = length;
  wire.sections = {
      {.length = 30.0, .bending_stiffness = 30.0, .twist_stiffness = 23.0},
      {.length = 30.0, .bending_stiffness = 260.0, .twist_stiffness = 200.0},
      {.length = length - 60.0, .bending_stiffness = 2300.0, .twist_stiffness = 1770.0}};
  wire.friction = friction;
  return wire;
}

inline Instrument uniform_wire(double length, double bending_stiffness, double friction) {
  Instrument wire;
  wire.id = "uniform-wire";
  wire.outer_diameter = 0.889;
  wire.length = length;
  wire.sections = {{.length = length,
                    .bending_stiffness = bending_stiffness,
                    .twist_stiffness = 0.77 * bending_stiffness}};
  wire.friction = friction;
  return wire;
}

// Bends to and fro in one plane, one after the other: a tube of radius 2 mm.
inline TubeWall winding_tube(double length, double bend_radius, double bend_angle) {
  TubeWall tube(2.0, Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX());
  tube.add_straight(20.0);
  tube.add_bend(bend_radius, 0.5 * bend_angle);
  for (double side = -1.0; tube.length() < length; side = -side) {
    tube.add_bend(bend_radius, side * bend_angle);
  }
  tube.add_straight(50.0);
  return tube;
}

// The hand of the benchmark: sums of sines from 0.7 to 6.7 Hz, up to 100 mm/s and 400 deg/s.
struct Hand {
  double feed = 0.0;  // mm/s
  double turn = 0.0;  // rad/s
};

inline Hand random_hand(double time) {
  const auto wave = [time](double frequency, double phase) {
    return std::sin(2.0 * kPi * frequency * time + phase);
  };
  return {.feed = 40.0 * wave(0.7, 0.0) + 35.0 * wave(2.3, 1.1) + 25.0 * wave(6.7, 2.3),
          .turn = 2.8 * wave(0.9, 0.4) + 2.4 * wave(2.9, 1.9) + 1.8 * wave(5.3, 0.8)};
}

// A wire of about `node_count` nodes laid along its path, for benchmarks. It is in free space, or
// in the scene `heavy`: a winding tube of radius 2 mm in which about a third of the nodes touch.
class LaidWire {
 public:
  LaidWire(int node_count, bool heavy)
      : inserted_(kElement * node_count - kSheath - kElement),
        tube_(winding_tube(inserted_ + 150.0, 36.0, 0.77)),
        rod_(stiff_wire(inserted_ + 200.0, 0.15), Access{}, heavy ? &tube_ : nullptr, inserted_,
             settings(), heavy ? tube_.axis(1.0) : straight_path(inserted_ + 1.0)) {}

  RodInstrument& rod() { return rod_; }

 private:
  static constexpr double kElement = 3.0;
  static constexpr double kSheath = 24.0;

  static RodSettings settings() {
    RodSettings settings;
    settings.element_length = kElement;
    settings.tip_element_length = kElement;
    settings.sheath_length = kSheath;
    return settings;
  }
  static std::vector<Vec3> straight_path(double length) {
    return {Vec3::Zero(), length * Vec3::UnitZ()};
  }

  double inserted_;
  TubeWall tube_;
  RodInstrument rod_;
};

}  // namespace sim::scenes
