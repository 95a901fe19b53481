#include "sim/validation/fed_wire.h"

#include <numbers>

#include "sim/validation/rod_setup.h"

namespace sim::validation {
namespace {

constexpr double kDiameter = 0.889;     // mm
constexpr double kTubeRadius = 3.0;     // mm
constexpr double kStraight = 40.0;      // mm before the bend
constexpr double kWireLength = 800.0;   // mm
constexpr double kStartInserted = 5.0;  // mm

RodSettings settings_for(const CaseRun& run, double element_length) {
  RodSettings settings;
  settings.time_step = run["dt"];
  settings.element_length = element_length;
  settings.tip_element_length = element_length;
  return settings;
}

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

}  // namespace

std::vector<ParameterDefinition> fed_wire_parameters() {
  return {{"mu", "friction coefficient", "1", 0.15, 0.0, 0.3},
          {"ei", "bending stiffness", "N mm^2", 300.0, 100.0, 2500.0},
          {"gj", "twist stiffness", "N mm^2", 230.0, 100.0, 2500.0},
          {"radius", "radius of the bend", "mm", 40.0, 20.0, 100.0},
          {"angle", "angle of the bend", "deg", 90.0, 30.0, 120.0},
          {"element_length", "length of an element", "mm", 3.0, 2.0, 4.0},
          {"dt", "time step", "s", 1e-3, 5e-4, 2e-3}};
}

TubeWall FedWire::make_tube(double radius, double angle) {
  TubeWall tube(kTubeRadius, Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX());
  tube.add_straight(kStraight);
  tube.add_bend(radius, angle);
  tube.add_straight(kWireLength);
  return tube;
}

FedWire::FedWire(const CaseRun& run, double element_length)
    : time_step_(run["dt"]),
      bend_end_(kStraight + run["radius"] * radians(run["angle"])),
      tube_(make_tube(run["radius"], radians(run["angle"]))),
      rod_(uniform_instrument(kWireLength, run["ei"], run["gj"], kDiameter, run["mu"]), Access{},
           &tube_, kStartInserted, settings_for(run, element_length)) {}

bool FedWire::step(double feed, double turn) {
  axial_ += feed;
  rotation_ += turn;
  return rod_.step(axial_, rotation_) == RodStatus::ok;
}

}  // namespace sim::validation
