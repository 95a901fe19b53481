#include <algorithm>
#include <cmath>

#include "sim/validation/case_run.h"
#include "sim/validation/fed_wire.h"
#include "sim/validation/rod_setup.h"

namespace sim::validation {
namespace {

constexpr double kSpeed = 30.0;       // mm/s
constexpr double kTurnRate = 1.0;     // rad/s, while it is fed
constexpr double kBeyondBend = 30.0;  // mm past the bend's end
constexpr double kSettle = 0.5;       // s after the hand has stopped
constexpr double kForceBound = 1.0;   // mN
constexpr double kTorqueBound = 1.0;  // mN mm

}  // namespace

CaseDefinition stiction_definition() {
  CaseDefinition definition{
      .id = "stiction",
      .title = "A wire that is let rest does not creep",
      .setup =
          "A wire is fed at 30 mm/s and turned through a bend, then the handle is held still. "
          "From 0.5 s after that, when vibration has died down, the handle's force and torque are "
          "watched.",
      .formula = "Coulomb friction at rest: nothing moves, so force and torque stay as they are.",
      .source = "Coulomb 1785; requirement: at most 1 mN in 5 s",
      .parameters = fed_wire_parameters()};
  definition.parameters.push_back({"hold_time", "time at rest", "s", 5.0, 1.0, 20.0});
  definition.parameters.front().minimum = 0.05;  // without friction there is nothing to stick
  return definition;
}

base::Status run_stiction(CaseRun& run) {
  FedWire wire(run);
  const double dt = wire.time_step();
  const double path = wire.bend_end() + kBeyondBend - wire.rod().inserted_length();
  const auto feed_steps = static_cast<int>(std::ceil(path / (kSpeed * dt)));
  const auto settle_steps = static_cast<int>(std::ceil(kSettle / dt));
  const auto hold_steps = static_cast<int>(std::ceil(run["hold_time"] / dt));
  const int total = feed_steps + hold_steps;

  double force_at_rest = 0.0;
  double torque_at_rest = 0.0;
  double force_creep = 0.0;
  double torque_creep = 0.0;
  for (int i = 0; i < total; ++i) {
    const bool feeding = i < feed_steps;
    if (!wire.step(feeding ? kSpeed * dt : 0.0, feeding ? kTurnRate * dt : 0.0)) {
      return simulation_failed();
    }
    if (i % 100 == 0) run.progress(static_cast<double>(i) / total);
    const int rested = i - feed_steps;
    if (rested < settle_steps) continue;
    if (rested == settle_steps) {
      force_at_rest = wire.rod().handle_force();
      torque_at_rest = wire.rod().handle_torque();
    }
    force_creep = std::max(force_creep, std::abs(wire.rod().handle_force() - force_at_rest));
    torque_creep = std::max(torque_creep, std::abs(wire.rod().handle_torque() - torque_at_rest));
  }
  run.simulated("force_at_rest", force_at_rest, "N");
  run.simulated("torque_at_rest", torque_at_rest, "N mm");
  run.simulated("force_creep", 1e3 * force_creep, "mN");
  run.simulated("torque_creep", 1e3 * torque_creep, "mN mm");
  run.simulated("contact_count", wire.rod().contact_count(), "1");
  run.expected("force_creep", 0.0, "mN", "Coulomb friction at rest");
  run.expected("torque_creep", 0.0, "mN mm", "Coulomb friction at rest");
  run.check("force_creep", 1e3 * force_creep, kForceBound, "mN");
  run.check("torque_creep", 1e3 * torque_creep, kTorqueBound, "mN mm");
  return base::Done{};
}

}  // namespace sim::validation
