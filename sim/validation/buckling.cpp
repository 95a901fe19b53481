#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/validation/case_run.h"
#include "sim/validation/elastica.h"
#include "sim/validation/rod_setup.h"

namespace sim::validation {
namespace {

// A straight rod with pinned ends that is shortened by moving one of them. It bends in the x-y
// plane; a small push aside at its middle chooses the side and is taken away afterwards.
class PinnedRod {
 public:
  PinnedRod(double length, double stiffness, double twist_stiffness, int elements, double force)
      : length_(length),
        mesh_(make_rod_mesh(uniform_instrument(length, stiffness, twist_stiffness, 1.0, 0.0),
                            {.element_length = length / elements,
                             .tip_element_length = length / elements,
                             .tip_mesh_length = length})),
        solver_(mesh_, static_settings(length, stiffness, force), nullptr),
        base_(mesh_.node_count() - 1),
        middle_(mesh_.node_count() / 2),
        seed_(1e-3 * force) {
    solver_.place(straight_nodes(mesh_, length), Vec3::UnitZ());
    for (std::size_t i = 0; i <= base_; ++i) solver_.hold_along(i, 2);
    solver_.hold(0);
    solver_.hold(base_);
    solver_.hold_twist(base_ - 1);
  }

  // Shortens it to (1 - shortening) of its length, in steps; false when that fails.
  bool shorten_to(double shortening) {
    constexpr int kSteps = 40;
    const double from = shortening_;
    if (from == 0.0) solver_.set_load(middle_, seed_ * Vec3::UnitY());
    for (int i = 0; i < kSteps; ++i) {
      solver_.move(0, -(shortening - from) * length_ / kSteps * Vec3::UnitX());
      if (solver_.step() != RodStatus::ok) return false;
    }
    solver_.set_load(middle_, Vec3::Zero());
    for (int i = 0; i < 3; ++i) {
      if (solver_.step() != RodStatus::ok) return false;
    }
    shortening_ = shortening;
    return solver_.residual() < seed_;
  }

  double force() const { return solver_.holding_force(base_).x(); }
  double deflection() const {
    double largest = 0.0;
    for (std::size_t i = 0; i <= base_; ++i) {
      largest = std::max(largest, std::abs(solver_.position(i).y()));
    }
    return largest;
  }

 private:
  double length_;
  RodMesh mesh_;
  RodSolver solver_;
  std::size_t base_, middle_;
  double seed_;  // N
  double shortening_ = 0.0;
};

}  // namespace

CaseDefinition buckling_definition() {
  return {.id = "buckling",
          .title = "Euler buckling of a rod with pinned ends",
          .setup =
              "A straight rod is shortened by moving one of its pinned ends; a small push "
              "aside chooses the side and is taken away. The critical load is what the end "
              "forces at an eighth and a quarter of the shortening extrapolate to at none.",
          .formula =
              "P = pi^2 EI / L^2; beyond it the elastica: P = (2 K(k) / pi)^2 pi^2 EI / L^2 "
              "at the end distance L (2 E(k) / K(k) - 1).",
          .source = "Euler 1744; Love, Treatise on the Mathematical Theory of Elasticity, art. 263",
          .parameters = {{"length", "length", "mm", 100.0, 10.0, 1000.0},
                         {"ei", "bending stiffness", "N mm^2", 1000.0, 0.1, 1e5},
                         {"gj", "twist stiffness", "N mm^2", 770.0, 0.1, 1e5},
                         {"shortening", "how far the ends come together, share of the length", "%",
                          1.0, 0.2, 20.0},
                         {"elements", "number of elements (even)", "1", 50, 10, 400, true}}};
}

base::Status run_buckling(CaseRun& run) {
  const double length = run["length"];
  const double stiffness = run["ei"];
  const int elements = run.whole("elements");
  const double shortening = run["shortening"] / 100.0;
  if (elements % 2 != 0) {
    return base::Error{base::ErrorCode::invalid_input,
                       "The parameter 'elements' must be even here, from 10 to 400, so that a node "
                       "lies in the middle."};
  }
  const double euler = std::numbers::pi * std::numbers::pi * stiffness / (length * length);

  PinnedRod rod(length, stiffness, run["gj"], elements, euler);
  double forces[3];
  const double shares[] = {0.125, 0.25, 1.0};
  for (int i = 0; i < 3; ++i) {
    if (!rod.shorten_to(shares[i] * shortening)) return simulation_failed();
    forces[i] = rod.force();
    run.progress((i + 1) / 3.0);
  }
  const double critical = 2.0 * forces[0] - forces[1];
  run.simulated("critical_load", critical, "N");
  run.simulated("end_force", forces[2], "N");
  run.simulated("middle_deflection", rod.deflection(), "mm");

  const BuckledRod exact = buckled_rod(shortening);
  run.expected("critical_load", euler, "N", "pi^2 EI / L^2");
  run.expected("end_force", exact.load_ratio * euler, "N", "elastica, elliptic integrals");
  run.expected("middle_deflection", exact.deflection_ratio * length, "mm",
               "elastica, elliptic integrals");
  run.check("critical_load", percent(critical, euler), mesh_bound(0.1, elements), "%");
  run.check("end_force", percent(forces[2], exact.load_ratio * euler), mesh_bound(0.1, elements),
            "%");
  run.check("middle_deflection", percent(rod.deflection(), exact.deflection_ratio * length),
            mesh_bound(0.1, elements), "%");
  return base::Done{};
}

}  // namespace sim::validation
