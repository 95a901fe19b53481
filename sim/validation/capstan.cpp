#include <cmath>
#include <numbers>
#include <sstream>
#include <vector>

#include "sim/validation/analytic_walls.h"
#include "sim/validation/case_run.h"
#include "sim/validation/rod_setup.h"

namespace sim::validation {
namespace {

constexpr double kDiameter = 0.889;  // mm
constexpr double kSpeed = 5.0;       // mm/s with which the rod is pulled
constexpr double kSettle = 3.0;      // elements pulled through before it is measured
constexpr double kMeasure = 2.0;     // elements during which it is
constexpr double kBareLength = 3.0;  // elements of straight rod on either side of the cylinder

constexpr double kLargestElementAngle = 12.0;  // deg

// EI / (T R^2): how much of the tension's work goes into bending the rod to the cylinder.
constexpr double kLargestStiffness = 2e-3;

// From the tip: a straight leg, the arc, a straight leg to the base.
std::vector<Vec3> wrapped_nodes(const RodMesh& mesh, double radius, double angle, double leg) {
  std::vector<Vec3> nodes;
  const double arc_length = radius * angle;
  const Vec3 last(std::cos(angle), std::sin(angle), 0.0);
  const Vec3 pull(-std::sin(angle), std::cos(angle), 0.0);
  for (double arc : mesh.arc) {
    const double beyond = arc - leg;
    if (beyond < 0.0) {
      nodes.emplace_back(radius, beyond, 0.0);
    } else if (beyond < arc_length) {
      const double turned = beyond / radius;
      nodes.emplace_back(radius * std::cos(turned), radius * std::sin(turned), 0.0);
    } else {
      nodes.push_back(radius * last + (beyond - arc_length) * pull);
    }
  }
  return nodes;
}

base::Status check_parameters(const CaseRun& run) {
  if (run["angle"] / run["elements"] > kLargestElementAngle) {
    return base::Error{base::ErrorCode::invalid_input,
                       "The parameter 'elements' must be large enough for an element to turn by at "
                       "most 12 degrees of 'angle'."};
  }
  const double ratio = run["ei"] / (run["tension"] * run["radius"] * run["radius"]);
  if (ratio <= kLargestStiffness) return base::Done{};
  std::ostringstream text;
  text << "The capstan formula holds for a limp rod only: ei / (tension radius^2) must be at most "
       << kLargestStiffness << ", with these it is " << ratio
       << "; lower 'ei' or raise 'tension' or 'radius'.";
  return base::Error{base::ErrorCode::invalid_input, text.str()};
}

}  // namespace

CaseDefinition capstan_definition() {
  return {.id = "capstan",
          .title = "Limp rod pulled around a cylinder",
          .setup =
              "A rod lies around a fixed cylinder with a dead load at its tip; its other end "
              "is pulled at 5 mm/s until it slips everywhere, and the pulling force is "
              "averaged while two elements pass.",
          .formula =
              "T2 / T1 = exp(mu theta), for a rod without bending stiffness. A stiff rod "
              "(ei above 2 N mm^2) does not follow it: its bending adds contact force.",
          .source = "Euler 1769, Eytelwein 1808",
          .parameters = {
              {"mu", "friction coefficient", "1", 0.1, 0.0, 0.3},
              {"angle", "angle of wrap", "deg", 180.0, 30.0, 360.0},
              {"radius", "radius of the cylinder", "mm", 35.0, 10.0, 100.0},
              {"tension", "dead load at the tip, T1", "N", 1.0, 0.1, 2.0},
              {"ei", "bending stiffness; ei / (tension radius^2) at most 0.002", "N mm^2", 2.0,
               1e-3, 2.0},
              {"gj", "twist stiffness", "N mm^2", 1.5, 1e-3, 2.0},
              {"elements", "elements around the arc, at most 12 deg each", "1", 30, 10, 200, true},
              {"dt", "time step", "s", 1e-3, 1e-4, 5e-3}}};
}

base::Status run_capstan(CaseRun& run) {
  if (auto good = check_parameters(run); !good) return good.error();
  const double angle = run["angle"] * std::numbers::pi / 180.0;
  const double radius = run["radius"] + 0.5 * kDiameter;
  const double element = radius * angle / run.whole("elements");
  const double leg = (kSettle + kMeasure + kBareLength) * element;
  const double length = radius * angle + leg + kBareLength * element;
  const double tension = run["tension"];

  const CylinderWall wall(Vec3::Zero(), Vec3::UnitZ(), run["radius"]);
  const RodMesh mesh =
      make_rod_mesh(uniform_instrument(length, run["ei"], run["gj"], kDiameter, run["mu"]),
                    {.element_length = element, .tip_element_length = element});
  RodSettings settings;
  settings.time_step = run["dt"];
  settings.tolerance = 1e-4 * tension;
  settings.wall_curvature = -1.0 / radius;  // bulges towards the rod
  RodSolver solver(mesh, settings, &wall);
  solver.place(wrapped_nodes(mesh, radius, angle, leg), Vec3::UnitZ());
  const std::size_t base = mesh.node_count() - 1;
  solver.hold(base);
  solver.hold_twist(base - 1);
  solver.set_load(0, -tension * Vec3::UnitY());

  const Vec3 pull(-std::sin(angle), std::cos(angle), 0.0);
  const double per_step = kSpeed * settings.time_step;
  const auto settle_steps = static_cast<int>(std::ceil(kSettle * element / per_step));
  const auto measure_steps = static_cast<int>(std::ceil(kMeasure * element / per_step));
  double sum = 0.0;
  double iterations = 0.0;
  int unconverged = 0;
  for (int i = 0; i < settle_steps + measure_steps; ++i) {
    solver.move(base, per_step * pull);
    if (solver.step() != RodStatus::ok) return simulation_failed();
    iterations += solver.iterations();
    if (solver.residual() > 5e-3) ++unconverged;
    if (i >= settle_steps) sum += solver.holding_force(base).dot(pull);
    if (i % 100 == 0) run.progress(static_cast<double>(i) / (settle_steps + measure_steps));
  }
  const double pulling = sum / measure_steps;
  run.simulated("pulling_force", pulling, "N");
  run.simulated("tension_ratio", pulling / tension, "1");
  run.simulated("contact_load", solver.contact().normal_load(), "N");
  run.simulated("mean_iterations", iterations / (settle_steps + measure_steps), "1");
  run.simulated("unconverged_steps", unconverged, "1");

  const double exact = std::exp(run["mu"] * angle);
  run.expected("tension_ratio", exact, "1", "exp(mu theta)");
  run.check("tension_ratio", percent(pulling / tension, exact), 1.5, "%");
  return base::Done{};
}

}  // namespace sim::validation
