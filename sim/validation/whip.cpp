#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "sim/validation/case_run.h"
#include "sim/validation/rod_setup.h"
#include "sim/validation/turned_wire.h"

namespace sim::validation {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kBound = 0.3;                   // deg, at 28 elements
constexpr double kDiameter = 0.889;              // mm
constexpr double kTurnPerStep = 1.0 / kDegrees;  // rad
constexpr double kLeastJump = 15.0 / kDegrees;   // rad of the tip in one step: it has whipped
constexpr double kLargest = 6.0;                 // of a: beyond it a whip is a leap of turns
constexpr double kSmallest = 0.2;
// Between these, around (pi / 2)^2, the tip turns so fast that it cannot be told from a whip.
constexpr double kFollows = 2.2, kWhips = 2.8;
// Elements beyond the bend, where the tube is straight: the last node of the bend then has a whole
// cell, as the free end of a rod has not.
constexpr int kTail = 5;
constexpr int kMostSteps = 2000;

class TurnedWire {
 public:
  TurnedWire(double tube_radius, double angle, double rest_radius, double bending, double twisting,
             int elements)
      : tube_radius_(tube_radius),
        bend_(tube_radius * angle),
        length_(bend_ * (elements + kTail) / elements),
        clamp_(static_cast<std::size_t>(elements + kTail)),
        mesh_(make_mesh(length_, 1.0 / rest_radius, bending, twisting, elements + kTail)),
        solver_(mesh_, make_settings(bend_, bending, twisting), nullptr) {
    std::vector<Vec3> nodes;
    for (const double arc : mesh_.arc) nodes.push_back(on_axis(length_ - arc));
    solver_.place(nodes, Vec3::UnitY());
    for (std::size_t i = 0; i < mesh_.node_count(); ++i) solver_.hold(i);
    solver_.hold_twist(clamp_);
  }

  bool turn(double angle) {
    // the rod's tangents point to the base: a turn of the base is one the other way about them
    solver_.turn(clamp_, -angle);
    // a wire that is about to whip takes several steps to get there
    for (int i = 0; i < kMostSteps; ++i) {
      const double before = tip_angle();
      if (solver_.step() != RodStatus::ok) return false;
      if (i > 0 && std::abs(tip_angle() - before) < 1e-6) break;
    }
    return true;
  }

  // From the tube's bend to the wire's own at the tip, about the direction of the tip; in (-pi,
  // pi].
  double tip_angle() const {
    const RodState& state = solver_.state();
    const Vec3 tangent = state.tangent[0];
    const Vec3 reference = state.reference[0];
    const Vec3 own =
        std::cos(state.twist[0]) * reference + std::sin(state.twist[0]) * tangent.cross(reference);
    const double at = bend_ / tube_radius_;
    const Vec3 inward(-std::sin(at), std::cos(at), 0.0);
    return std::atan2(inward.cross(own).dot(-tangent), inward.dot(own));
  }

 private:
  static RodMesh make_mesh(double length, double curvature, double bending, double twisting,
                           int elements) {
    Instrument instrument = uniform_instrument(length, bending, twisting, kDiameter, 0.0);
    instrument.tip_bends = {{0.0, length, curvature}};
    return clamped_mesh(instrument, elements);
  }
  static RodSettings make_settings(double length, double bending, double twisting) {
    RodSettings settings = static_settings(length, bending, 1e-3 * bending / (length * length));
    // enough resistance to turning that the wire slides down from where it stood, instead of
    // leaping to an equilibrium far away
    settings.twist_drag = 0.01 * settings.time_step * twisting / (length * length);
    return settings;
  }
  Vec3 on_axis(double arc) const {
    if (arc < 0.0) return {arc, 0.0, 0.0};
    const double at = std::min(arc, bend_) / tube_radius_;
    const double beyond = std::max(0.0, arc - bend_);
    return {tube_radius_ * std::sin(at) + beyond * std::cos(at),
            tube_radius_ * (1.0 - std::cos(at)) + beyond * std::sin(at), 0.0};
  }

  double tube_radius_, bend_, length_;  // mm
  std::size_t clamp_;
  RodMesh mesh_;
  RodSolver solver_;
};

}  // namespace

CaseDefinition whip_definition() {
  return {
      .id = "whip",
      .title = "Bent wire turned in a bend: it lags, then whips around",
      .setup =
          "A wire bent at rest lies on the axis of a tube that is bent in a circle and ends "
          "straight: every node is held there, free to turn. It is turned at its base, a degree "
          "at a time, until its tip has whipped around (or for a full turn where it does not).",
      .formula =
          "GJ psi'' = EI kappa_wire kappa_tube sin(psi), psi the base's angle at the base, psi' "
          "= 0 at the tip: the base's angle for each tip's angle, by integration; its maximum "
          "is where the tip whips around.",
      .source =
          "Dupont et al., IEEE Trans. Robotics 26 (2010) 209, for a tube whose centreline is "
          "given",
      .parameters = {
          {"radius", "radius of the tube's bend", "mm", 35.0, 15.0, 100.0},
          {"angle", "angle of the tube's bend", "deg", 90.0, 30.0, 180.0},
          {"rest_radius", "radius to which the wire is bent at rest", "mm", 25.0, 10.0, 200.0},
          {"ei", "bending stiffness", "N mm^2", 30.0, 1.0, 5000.0},
          {"gj", "twist stiffness; L^2 ei / (gj radius rest_radius) from 0.2 to 2.2 or 2.8 to 6",
           "N mm^2", 23.0, 1.0, 5000.0},
          {"elements", "number of elements in the bend", "1", 28, 14, 200, true}}};
}

base::Status run_whip(CaseRun& run) {
  const double radius = run["radius"];
  const double angle = run["angle"] / kDegrees;
  const double length = radius * angle;
  const double a = length * length * run["ei"] / (run["gj"] * radius * run["rest_radius"]);
  if (a < kSmallest || a > kLargest || (a > kFollows && a < kWhips)) {
    return base::Error{base::ErrorCode::invalid_input,
                       "The parameters must give L^2 ei / (gj radius rest_radius) between 0.2 and "
                       "2.2, where the tip follows, or 2.8 and 6, where it clearly whips; with "
                       "these it is " +
                           std::to_string(a) + "."};
  }

  TurnedWire wire(radius, angle, run["rest_radius"], run["ei"], run["gj"], run.whole("elements"));
  const int steps = 360;
  double tip = 0.0;
  std::vector<double> errors;  // rad, of the base's angle
  double largest_lag = 0.0;
  std::optional<double> whipped;
  for (int i = 1; i <= steps && !whipped; ++i) {
    const double base = i * kTurnPerStep;
    if (!wire.turn(kTurnPerStep)) return simulation_failed();
    const double moved = std::remainder(wire.tip_angle() - tip, 2.0 * std::numbers::pi);
    if (std::abs(moved) > kLeastJump) {
      whipped = base - 0.5 * kTurnPerStep;
      break;
    }
    tip += moved;
    errors.push_back(std::abs(base - base_angle(a, tip)));
    largest_lag = std::max(largest_lag, base - tip);
    run.progress(static_cast<double>(i) / steps);
  }

  // just before it whips the wire creeps on for longer than is waited here
  if (whipped) errors.resize(errors.size() - 2);
  const double worst = *std::max_element(errors.begin(), errors.end());

  run.simulated("base_angle_error", worst * kDegrees, "deg");
  run.simulated("largest_lag", largest_lag * kDegrees, "deg");
  run.expected("base_angle_error", 0.0, "deg", "GJ psi'' = EI kappa_wire kappa_tube sin(psi)");
  const double fineness = 28.0 / std::min(28, run.whole("elements"));
  const double bound = kBound * fineness * fineness;
  run.check("base_angle_error", worst * kDegrees, bound, "deg");
  const std::optional<double> expected = whip_angle(a);
  if (whipped) run.simulated("whip_angle", *whipped * kDegrees, "deg");
  if (expected) {
    run.expected("whip_angle", *expected * kDegrees, "deg", "largest base angle of the branch");
  }
  if (whipped && expected) {
    run.check("whip_angle", (*whipped - *expected) * kDegrees, bound + 0.5, "deg");
  } else {
    // both must agree on whether there is a whip at all
    run.check("whips", static_cast<double>(whipped.has_value()) - expected.has_value(), 0.0, "1");
  }
  return base::Done{};
}

}  // namespace sim::validation
