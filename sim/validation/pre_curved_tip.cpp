#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "sim/validation/analytic_walls.h"
#include "sim/validation/case_run.h"
#include "sim/validation/elastica.h"
#include "sim/validation/rod_setup.h"

namespace sim::validation {
namespace {

constexpr double kDiameter = 0.889;  // mm
constexpr double kFewestInBend = 6.0;

// The bent wire of the case, its clamp at the origin, its bend towards +y.
struct BentWire {
  double length, bend_length, angle, stiffness;

  Elastica under(double force) const {
    return bent_cantilever(length, stiffness, bend_length, angle / bend_length, force);
  }
};

// How deep the tip's node sinks into the wall under `force`: the wall is elastic, with the
// stiffness that the settings give a node standing for half an element.
double depth_under(double force, double stiffness, double onset) {
  const double at_onset = 0.5 * stiffness * onset;
  return force < at_onset ? std::sqrt(2.0 * onset * force / stiffness)
                          : force / stiffness + 0.5 * onset;
}

// The force -F on the tip that brings its height down to `height` plus the wall's own give.
double wall_force(const BentWire& wire, double height, double stiffness, double onset) {
  double low = 0.0;
  // well above what the linear beam needs
  double high = 6.0 * wire.stiffness * wire.under(0.0).y / std::pow(wire.length, 3);
  for (int i = 0; i < 60; ++i) {
    const double force = 0.5 * (low + high);
    const bool too_weak = wire.under(-force).y > height + depth_under(force, stiffness, onset);
    (too_weak ? low : high) = force;
  }
  return 0.5 * (low + high);
}

}  // namespace

CaseDefinition pre_curved_tip_definition() {
  return {.id = "pre-curved-tip",
          .title = "Bent tip pressing on a wall",
          .setup =
              "A clamped wire whose last stretch is bent at rest stands along a wall that "
              "comes closer in steps, from where the tip is free to the given share of its "
              "free height above the wire's axis. The wall is smooth and elastic.",
          .formula =
              "The elastica with rest curvature, EI (theta' - kappa_0) = M, M' = F "
              "cos(theta), pressed to the wall's height plus the depth to which the wall "
              "itself gives way under F; solved by shooting.",
          .source = "Kirchhoff 1859; Love, Treatise on Elasticity, art. 262",
          .parameters = {
              {"length", "free length", "mm", 60.0, 20.0, 200.0},
              {"bend_length", "length of the bent stretch at the tip; at most 0.8 length", "mm",
               20.0, 5.0, 100.0},
              {"angle", "angle of the bend at rest", "deg", 45.0, 5.0, 80.0},
              {"height",
               "height of the wall over the wire's axis, share of the tip's "
               "height at rest",
               "%", 50.0, 30.0, 75.0},
              {"ei", "bending stiffness", "N mm^2", 30.0, 1.0, 5000.0},
              {"gj", "twist stiffness", "N mm^2", 23.0, 1.0, 5000.0},
              {"elements", "number of elements; at least 6 in the bend", "1", 50, 20, 400, true}}};
}

base::Status run_pre_curved_tip(CaseRun& run) {
  const double length = run["length"];
  const double stiffness = run["ei"];
  const int elements = run.whole("elements");
  const BentWire wire{length, run["bend_length"], run["angle"] * std::numbers::pi / 180.0,
                      stiffness};
  if (wire.bend_length > 0.8 * length) {
    return base::Error{base::ErrorCode::invalid_input,
                       "The parameter 'bend_length' must be at most 0.8 times 'length', which "
                       "leaves a straight stretch."};
  }
  const double in_bend = wire.bend_length / length * elements;
  if (in_bend < kFewestInBend) {
    return base::Error{base::ErrorCode::invalid_input,
                       "The parameter 'elements' must put at least 6 elements into 'bend_length'; "
                       "with these it is " +
                           std::to_string(in_bend) + "."};
  }
  // as fine as 50 elements when 16 of them lie in the bend, as at the defaults
  const int fineness = std::min(elements, static_cast<int>(std::lround(3.0 * in_bend)));
  const double free_height = wire.under(0.0).y;
  const double height = run["height"] / 100.0 * free_height;
  const double scale = stiffness * free_height / std::pow(length, 3);

  Instrument instrument = uniform_instrument(length, stiffness, run["gj"], kDiameter, 0.0);
  instrument.tip_bends = {{0.0, wire.bend_length, wire.angle / wire.bend_length}};
  const RodMesh mesh = clamped_mesh(instrument, elements);
  RodSettings settings = static_settings(length, stiffness, scale);
  // a wall that gives way by a few thousandths of the height, so that only the tip touches it
  const double wall_stiffness = 1e3 * scale / free_height;
  settings.contact_stiffness = wall_stiffness;
  settings.contact_onset = 1e-3 * free_height;
  settings.contact_hardening = 0.0;
  // the node touches when it is a radius away from the plane
  const auto wall_at = [](double y) {
    return PlaneWall(Vec3(0.0, y + 0.5 * kDiameter, 0.0), -Vec3::UnitY());
  };
  PlaneWall wall = wall_at(1.1 * free_height);
  RodSolver solver(mesh, settings, &wall);
  solver.place(straight_nodes(mesh, length), Vec3::UnitY());
  const auto clamp = static_cast<std::size_t>(elements);
  solver.hold(clamp);
  solver.hold(clamp + 1);
  solver.hold_twist(clamp);

  constexpr int kSteps = 60;
  for (int i = 1; i <= kSteps + 3; ++i) {
    const double share = std::min(1.0, static_cast<double>(i) / kSteps);
    wall = wall_at((1.0 - share) * 1.1 * free_height + share * height);
    if (solver.step() != RodStatus::ok) return simulation_failed();
    run.progress(static_cast<double>(i) / (kSteps + 3));
  }
  if (solver.residual() > 1e-3 * scale) return simulation_failed();

  const double force = solver.contact().normal_load();
  run.simulated("wall_force", force, "N");
  run.simulated("tip_height", solver.position(0).y(), "mm");
  run.simulated("contact_count", solver.contact().contact_count(), "1");
  run.simulated("clamp_force",
                -solver.holding_force(clamp).y() - solver.holding_force(clamp + 1).y(), "N");

  const double exact = wall_force(wire, height, wall_stiffness, settings.contact_onset);
  run.expected("wall_force", exact, "N", "elastica with rest curvature, by shooting");
  run.expected("tip_height", wire.under(-exact).y, "mm", "elastica with rest curvature");
  run.check("wall_force", percent(force, exact), mesh_bound(0.5, fineness), "%");
  run.check("tip_height", 100.0 * (solver.position(0).y() - wire.under(-exact).y) / free_height,
            mesh_bound(0.5, fineness), "% of free height");
  return base::Done{};
}

}  // namespace sim::validation
