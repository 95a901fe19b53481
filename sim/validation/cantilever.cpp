#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/validation/case_run.h"
#include "sim/validation/elastica.h"
#include "sim/validation/rod_setup.h"

namespace sim::validation {
namespace {

constexpr double kLargestRatio = 20.0;
constexpr double kSmallestRatio = 1e-4;
constexpr double kDegrees = 180.0 / std::numbers::pi;

}  // namespace

CaseDefinition cantilever_definition() {
  return {.id = "cantilever",
          .title = "Cantilever under a dead load at its tip",
          .setup =
              "A straight rod, clamped at one end, is loaded in steps across its tip by a "
              "force that keeps its direction, and left to find its equilibrium.",
          .formula =
              "The elastica EI theta'' = -P cos(theta), theta(0) = 0, theta'(L) = 0, solved "
              "as a differential equation by shooting; any deflection.",
          .source = "Bisshopp and Drucker, Quarterly of Applied Mathematics 3 (1945) 272",
          .parameters = {{"length", "free length", "mm", 100.0, 10.0, 1000.0},
                         {"ei", "bending stiffness", "N mm^2", 1000.0, 0.1, 1e5},
                         {"gj", "twist stiffness", "N mm^2", 770.0, 0.1, 1e5},
                         {"load", "force at the tip; load length^2 / ei from 0.0001 to 20", "N",
                          0.1, 1e-9, 1e4},
                         {"elements", "number of elements", "1", 50, 20, 400, true}}};
}

base::Status run_cantilever(CaseRun& run) {
  const double length = run["length"];
  const double stiffness = run["ei"];
  const double load = run["load"];
  const int elements = run.whole("elements");
  const double ratio = load * length * length / stiffness;
  if (ratio < kSmallestRatio || ratio > kLargestRatio) {
    return base::Error{base::ErrorCode::invalid_input,
                       "The parameter 'load' must give load length^2 / ei between 0.0001 and 20; "
                       "with these it is " +
                           std::to_string(ratio) + "."};
  }

  const RodMesh mesh =
      clamped_mesh(uniform_instrument(length, stiffness, run["gj"], 1.0, 0.0), elements);
  RodSolver solver(mesh, static_settings(length, stiffness, load), nullptr);
  solver.place(straight_nodes(mesh, length), Vec3::UnitZ());
  const auto clamp = static_cast<std::size_t>(elements);
  solver.hold(clamp);
  solver.hold(clamp + 1);
  solver.hold_twist(clamp);
  const int steps = 4 + static_cast<int>(std::ceil(4.0 * ratio));
  for (int i = 1; i <= steps + 2; ++i) {
    solver.set_load(0, std::min(1.0, static_cast<double>(i) / steps) * load * Vec3::UnitY());
    if (solver.step() != RodStatus::ok || solver.residual() > 1e-5 * load) {
      return simulation_failed();
    }
    run.progress(static_cast<double>(i) / (steps + 2));
  }

  const Vec3 tip = solver.position(0);
  const Vec3 direction = -solver.state().tangent[0];
  const double angle = std::atan2(direction.y(), direction.x());
  run.simulated("tip_deflection", tip.y(), "mm");
  run.simulated("tip_shortening", length - tip.x(), "mm");
  run.simulated("tip_angle", angle * kDegrees, "deg");
  run.simulated("clamp_force",
                -solver.holding_force(clamp).y() - solver.holding_force(clamp + 1).y(), "N");

  const Elastica exact = loaded_cantilever(length, stiffness, load);
  const char* const source = "elastica, by shooting";
  run.expected("tip_deflection", exact.y, "mm", source);
  run.expected("tip_shortening", length - exact.x, "mm", source);
  run.expected("tip_angle", exact.angle * kDegrees, "deg", source);
  run.expected("clamp_force", load, "N", "balance of forces");
  run.check("tip_deflection", percent(tip.y(), exact.y), mesh_bound(0.05, elements), "%");
  run.check("tip_shortening", 100.0 * (exact.x - tip.x()) / length, mesh_bound(0.05, elements),
            "% of length");
  run.check("tip_angle", percent(angle, exact.angle), mesh_bound(0.05, elements), "%");
  return base::Done{};
}

}  // namespace sim::validation
