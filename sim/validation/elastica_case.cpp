#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "sim/validation/case_run.h"
#include "sim/validation/elastica.h"
#include "sim/validation/rod_setup.h"

namespace sim::validation {
namespace {

constexpr double kLargestRatio = 12.0;
constexpr double kSmallestRatio = 0.1;
constexpr double kDegrees = 180.0 / std::numbers::pi;

}  // namespace

CaseDefinition elastica_definition() {
  return {.id = "elastica",
          .title = "Rod bent back by an oblique dead load: the whole curve",
          .setup =
              "A straight rod, clamped at one end, is loaded in steps at its tip by a force that "
              "keeps its direction, obliquely back towards the clamp, until the rod turns over. "
              "Every node is compared with the point of the exact curve at its arc length.",
          .formula =
              "EI theta'' = -P sin(direction - theta), theta(0) = 0, theta'(L) = 0, solved as a "
              "differential equation by shooting.",
          .source = "Euler 1744; Love, Treatise on the Mathematical Theory of Elasticity, art. 260",
          .parameters = {
              {"length", "free length", "mm", 100.0, 10.0, 1000.0},
              {"ei", "bending stiffness", "N mm^2", 1000.0, 0.1, 1e5},
              {"gj", "twist stiffness", "N mm^2", 770.0, 0.1, 1e5},
              {"load", "force at the tip; load length^2 / ei from 0.1 to 12", "N", 0.5, 1e-9, 1e4},
              {"direction", "of the force, from the rod at rest; 90 is across it", "deg", 135.0,
               30.0, 160.0},
              {"elements", "number of elements", "1", 100, 20, 400, true}}};
}

base::Status run_elastica(CaseRun& run) {
  const double length = run["length"];
  const double stiffness = run["ei"];
  const double load = run["load"];
  const double direction = run["direction"] / kDegrees;
  const int elements = run.whole("elements");
  const double ratio = load * length * length / stiffness;
  if (ratio < kSmallestRatio || ratio > kLargestRatio) {
    return base::Error{base::ErrorCode::invalid_input,
                       "The parameter 'load' must give load length^2 / ei between 0.1 and 12; "
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
  // the force first acts across the rod and is turned while it grows: pressed from its straight
  // state the rod could bend either way
  const int steps = 20 + static_cast<int>(std::ceil(8.0 * ratio));
  for (int i = 1; i <= steps + 3; ++i) {
    const double share = std::min(1.0, static_cast<double>(i) / steps);
    const double turned = std::numbers::pi / 2.0 + share * (direction - std::numbers::pi / 2.0);
    solver.set_load(0, share * load * Vec3(std::cos(turned), std::sin(turned), 0.0));
    if (solver.step() != RodStatus::ok || solver.residual() > 1e-5 * load) {
      return simulation_failed();
    }
    run.progress(static_cast<double>(i) / (steps + 3));
  }

  const auto curve = loaded_cantilever_shape(length, stiffness, load, direction, elements);
  double largest = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Vec3 node = solver.position(clamp - i);
    largest = std::max(largest,
                       std::hypot(node.x() - curve[i].first, node.y() - curve[i].second, node.z()));
  }
  const Vec3 tip = solver.position(0);
  const Vec3 heading = -solver.state().tangent[0];
  double angle = std::atan2(heading.y(), heading.x());
  if (angle < 0.0) angle += 2.0 * std::numbers::pi;
  run.simulated("tip_x", tip.x(), "mm");
  run.simulated("tip_y", tip.y(), "mm");
  run.simulated("tip_angle", angle * kDegrees, "deg");
  run.simulated("farthest_node", largest, "mm");

  const Elastica exact = loaded_cantilever(length, stiffness, load, direction);
  const char* const source = "elastica, by shooting";
  run.expected("tip_x", exact.x, "mm", source);
  run.expected("tip_y", exact.y, "mm", source);
  run.expected("tip_angle", exact.angle * kDegrees, "deg", source);
  run.expected("farthest_node", 0.0, "mm", source);
  // bent over by up to 150 degrees it asks for twice the elements of a cantilever
  const double bound = mesh_bound(0.05, elements / 2);
  run.check("tip_x", 100.0 * (tip.x() - exact.x) / length, bound, "% of length");
  run.check("tip_y", 100.0 * (tip.y() - exact.y) / length, bound, "% of length");
  run.check("tip_angle", percent(angle, exact.angle), bound, "%");
  run.check("farthest_node", 100.0 * largest / length, bound, "% of length");
  return base::Done{};
}

}  // namespace sim::validation
