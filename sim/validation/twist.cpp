#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <optional>

#include "sim/validation/case_run.h"
#include "sim/validation/rod_setup.h"
#include "sim/validation/twisted_rod.h"

namespace sim::validation {
namespace {

constexpr double kCriticalBound = 0.4;  // %, at 50 elements

// A straight rod between two clamps, one of which turns and may slide along the rod's axis. Node 1
// and node `elements` + 1 are where the clamps begin.
class ClampedRod {
 public:
  ClampedRod(double length, double bending, double twisting, int elements)
      : length_(length),
        bending_(bending),
        middle_(static_cast<std::size_t>(elements) / 2 + 1),
        mesh_(make_mesh(length, bending, twisting, elements)),
        solver_(mesh_, static_settings(length, bending, push(bending, length)), nullptr) {
    const auto clamp = static_cast<std::size_t>(elements) + 1;
    solver_.place(straight_nodes(mesh_, length + length / elements), Vec3::UnitY());
    for (const std::size_t node : {std::size_t{0}, std::size_t{1}}) {
      solver_.hold_along(node, 1);
      solver_.hold_along(node, 2);
    }
    solver_.hold_twist(0);
    solver_.hold(clamp);
    solver_.hold(clamp + 1);
    solver_.hold_twist(clamp);
  }

  // Turns the sliding clamp to `angle` (rad) altogether, with the push aside on. False: failed.
  bool turn_to(double angle) {
    const int steps = 1 + static_cast<int>(std::abs(angle - angle_) / 0.2);
    const double part = (angle - angle_) / steps;
    solver_.set_load(middle_, push(bending_, length_) * Vec3::UnitY());
    for (int i = 0; i < steps + 2; ++i) {
      if (i < steps) solver_.turn(0, part);
      if (solver_.step() != RodStatus::ok) return false;
    }
    angle_ = angle;
    return solver_.residual() < 1e-4 * push(bending_, length_);
  }

  double torque() const { return std::abs(solver_.holding_moment(0)); }
  // In the units of the push: mm aside over what the untwisted rod yields.
  std::complex<double> deflection() const {
    const Vec3 middle = solver_.position(middle_);
    const double unit = push(bending_, length_) * std::pow(length_, 3) / (192.0 * bending_);
    return {middle.y() / unit, middle.z() / unit};
  }

 private:
  // So weak that the rod stays straight but for the second order.
  static double push(double bending, double length) { return 2e-3 * bending / (length * length); }

  static RodMesh make_mesh(double length, double bending, double twisting, int elements) {
    const double element = length / elements;
    RodMesh mesh = clamped_mesh(uniform_instrument(length + element, bending, twisting, 1.0, 0.0),
                                elements + 1);
    // the cell of a clamp is half a cell, at this end too
    mesh.bending[1] *= 2.0;
    mesh.twisting[1] *= 2.0;
    return mesh;
  }

  double length_, bending_;
  std::size_t middle_;
  RodMesh mesh_;
  RodSolver solver_;
  double angle_ = 0.0;
};

}  // namespace

CaseDefinition twist_definition() {
  return {
      .id = "twist",
      .title = "Twisted rod between clamps, up to where it writhes",
      .setup =
          "A straight rod between two clamps, one of which may slide, is twisted at that end "
          "and pushed aside in its middle by a force so small that it stays all but straight. "
          "The critical torque is where the deflections at 75, 85 and 90 % of 9 EI / L "
          "extrapolate to infinity as A / (M_c^2 - M^2) + B.",
      .formula =
          "Torque GJ angle / L. Pushed aside: EI u'''' - i M u''' = P at the middle, u = u' = "
          "0 at the clamps, u the deflection as a complex number. It loses its stiffness at M "
          "= 2 x EI / L with tan(x) = x: 8.9868 EI / L.",
      .source = "Greenhill 1883; Love, Treatise on Elasticity, art. 272",
      .parameters = {{"length", "length between the clamps", "mm", 100.0, 10.0, 1000.0},
                     {"ei", "bending stiffness", "N mm^2", 1000.0, 0.1, 1e5},
                     {"gj", "twist stiffness; 0.2 to 5 times ei", "N mm^2", 770.0, 0.1, 1e5},
                     {"share", "torque at which the deflection is compared, of the critical one",
                      "%", 80.0, 10.0, 95.0},
                     {"elements", "number of elements (even)", "1", 50, 20, 400, true}}};
}

base::Status run_twist(CaseRun& run) {
  const double length = run["length"];
  const double bending = run["ei"];
  const double twisting = run["gj"];
  const int elements = run.whole("elements");
  if (elements % 2 != 0) {
    return base::Error{base::ErrorCode::invalid_input,
                       "The parameter 'elements' must be even here, from 20 to 400, so that a node "
                       "lies in the middle."};
  }
  if (twisting < 0.2 * bending || twisting > 5.0 * bending) {
    return base::Error{base::ErrorCode::invalid_input,
                       "The parameter 'gj' must be between 0.2 and 5 times 'ei'; a round wire of "
                       "one material has 0.77."};
  }
  const double unit = bending / length;  // of torque, N mm
  const double share = run["share"] / 100.0;

  ClampedRod rod(length, bending, twisting, elements);
  const double angle = share * kCriticalTorque * unit * length / twisting;
  if (!rod.turn_to(angle)) return simulation_failed();
  const double torque = rod.torque();
  const std::complex<double> deflection = rod.deflection();
  run.progress(0.4);

  ClampedRod towards(length, bending, twisting, elements);
  TorqueResponse responses[3];
  const double levels[] = {0.75 * 9.0, 0.85 * 9.0, 0.9 * 9.0};
  for (int i = 0; i < 3; ++i) {
    if (!towards.turn_to(levels[i] * unit * length / twisting)) return simulation_failed();
    responses[i] = {towards.torque(), std::abs(towards.deflection())};
    run.progress(0.4 + 0.2 * (i + 1));
  }
  const std::optional<double> critical = extrapolated_critical_torque(responses);
  if (!critical) return simulation_failed();

  run.simulated("torque", torque, "N mm");
  run.simulated("deflection", std::abs(deflection), "of the untwisted rod's");
  run.simulated("deflection_angle", std::arg(deflection) * 180.0 / std::numbers::pi, "deg");
  run.simulated("critical_torque", *critical, "N mm");
  const std::complex<double> exact = twisted_rod_deflection(share * kCriticalTorque);
  run.expected("torque", twisting * angle / length, "N mm", "GJ angle / L");
  run.expected("deflection", std::abs(exact), "of the untwisted rod's",
               "EI u'''' - i M u''' = P, clamped ends");
  run.expected("critical_torque", kCriticalTorque * unit, "N mm", "2 x EI / L, tan(x) = x");
  run.check("torque", percent(torque, twisting * angle / length), mesh_bound(0.1, elements), "%");
  // near the critical torque a small error of it is a large one of the deflection
  const double amplification = 2.0 * share * share / (1.0 - share * share);
  run.check("deflection", percent(std::abs(deflection), std::abs(exact)),
            mesh_bound(0.3 + kCriticalBound * amplification, elements), "%");
  run.check("critical_torque", percent(*critical, kCriticalTorque * unit),
            mesh_bound(kCriticalBound, elements), "%");
  return base::Done{};
}

}  // namespace sim::validation
