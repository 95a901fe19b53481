#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/validation/case_run.h"
#include "sim/validation/fed_wire.h"
#include "sim/validation/rod_setup.h"

namespace sim::validation {
namespace {

constexpr double kSpeed = 30.0;       // mm/s
constexpr double kBeyondBend = 30.0;  // mm past the bend's end where the force is first taken
constexpr double kMeasured = 40.0;    // mm of feed over which it is averaged
constexpr double kBound = 1.0;        // %, at elements of 3 mm
constexpr double kDrawnBound = 1.0;   // % per mm of element: of first order only

struct MeanForce {
  double fed = 0.0, drawn = 0.0;  // N, the second while the wire is drawn back again
};

std::optional<MeanForce> mean_force(const CaseRun& run, double element_length, double from,
                                    double to) {
  FedWire wire(run, element_length);
  const double feed = kSpeed * wire.time_step();
  const double lead = wire.bend_end() + kBeyondBend - wire.rod().inserted_length();
  const auto lead_steps = static_cast<int>(std::ceil(lead / feed));
  const auto steps = static_cast<int>(std::ceil(kMeasured / feed));
  const int total = lead_steps + 2 * steps;
  MeanForce mean;
  for (int i = 0; i < total; ++i) {
    const bool forwards = i < lead_steps + steps;
    if (!wire.step(forwards ? feed : -feed, 0.0)) return std::nullopt;
    // the first half of the way back is where friction turns round
    if (i >= lead_steps && forwards) mean.fed += wire.rod().handle_force() / steps;
    if (i >= total - steps / 2) mean.drawn += wire.rod().handle_force() / (steps / 2);
    if (i % 100 == 0) run.progress(from + (to - from) * i / total);
  }
  return mean;
}

}  // namespace

CaseDefinition handle_force_definition() {
  CaseDefinition definition{
      .id = "handle-force",
      .title = "The hand's force does not depend on the mesh",
      .setup =
          "A wire is fed at 30 mm/s through a bend and drawn back, once with elements of the given "
          "length and once with elements of 1 mm. The force at the handle is averaged over 40 mm "
          "of "
          "feed beyond the bend and over 20 mm of the way back.",
      .formula =
          "The mean forces of both meshes agree: fed within 1 % up to elements of 3 mm, drawn back "
          "within "
          "1 % per mm of element.",
      .source = "requirement",
      .parameters = fed_wire_parameters()};
  for (ParameterDefinition& parameter : definition.parameters) {
    // without friction there is next to no force; with more the tip digs into the wall
    if (parameter.id == "mu") {
      parameter.minimum = 0.1;
      parameter.maximum = 0.2;
    }
    if (parameter.id == "radius") parameter.minimum = 30.0;
  }
  return definition;
}

base::Status run_handle_force(CaseRun& run) {
  const double element = run["element_length"];
  const auto coarse = mean_force(run, element, 0.0, 0.3);
  if (!coarse) return simulation_failed();
  const auto fine = mean_force(run, 1.0, 0.3, 1.0);
  if (!fine) return simulation_failed();
  run.simulated("mean_force_fed", coarse->fed, "N");
  run.simulated("mean_force_drawn", coarse->drawn, "N");
  run.expected("mean_force_fed", fine->fed, "N", "the same with elements of 1 mm");
  run.expected("mean_force_drawn", fine->drawn, "N", "the same with elements of 1 mm");
  const double coarser = std::max(1.0, element / 3.0);
  const double bound = kBound * coarser * coarser;
  run.check("mean_force_fed", percent(coarse->fed, fine->fed), bound, "%");
  run.check("mean_force_drawn", percent(coarse->drawn, fine->drawn), kDrawnBound * element, "%");
  return base::Done{};
}

}  // namespace sim::validation
