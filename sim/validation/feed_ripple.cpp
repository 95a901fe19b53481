#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sim/validation/case_run.h"
#include "sim/validation/fed_wire.h"
#include "sim/validation/rod_setup.h"

namespace sim::validation {
namespace {

constexpr double kMeasured = 40.0;     // mm of feed during which the force is looked at
constexpr double kBeyondBend = 30.0;   // mm past the bend's end where that starts
constexpr double kWindow = 0.02;       // s: what varies more slowly is not ripple (50 Hz)
constexpr double kRippleBound = 2.0;   // mN, root mean square
constexpr double kChangeBound = 15.0;  // mN per ms

// Root mean square of the force less its moving average over `window` samples.
double ripple(const std::vector<double>& force, std::size_t window) {
  double sum = 0.0;
  double squares = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    sum += force[i];
    if (i >= window) sum -= force[i - window];
    if (i + 1 < window) continue;
    const double centre = force[i + 1 - (window + 1) / 2];
    const double difference = centre - sum / static_cast<double>(window);
    squares += difference * difference;
    ++count;
  }
  return std::sqrt(squares / static_cast<double>(count));
}

}  // namespace

CaseDefinition feed_ripple_definition() {
  CaseDefinition definition{
      .id = "feed-ripple",
      .title = "Feeding is smooth although the rod grows element by element",
      .setup =
          "A wire is fed at a steady speed from 5 mm inserted, through a bend and beyond it. "
          "Ripple is what the handle's force holds above 50 Hz while 40 mm are fed with the "
          "tip past the bend; the largest change is taken from the first millimetre on.",
      .formula = "A continuous wire has no elements: the force must not show them.",
      .source =
          "requirement: at most 2 mN rms and 15 mN per ms at 30 mm/s, well below what a hand "
          "feels",
      .parameters = fed_wire_parameters()};
  for (ParameterDefinition& parameter : definition.parameters) {
    // beyond these the tip digs into the wall and the wire snaps past it: no longer a smooth feed
    if (parameter.id == "mu") parameter.maximum = 0.2;
    if (parameter.id == "radius") parameter.minimum = 30.0;
    if (parameter.id == "element_length") parameter.maximum = 3.0;
  }
  definition.parameters.push_back({"speed", "feed", "mm/s", 30.0, 5.0, 30.0});
  return definition;
}

base::Status run_feed_ripple(CaseRun& run) {
  FedWire wire(run);
  const double dt = wire.time_step();
  const double feed = run["speed"] * dt;
  const double lead = wire.bend_end() + kBeyondBend - wire.rod().inserted_length();
  const auto lead_steps = static_cast<int>(std::ceil(lead / feed));
  const auto measure_steps = static_cast<int>(std::ceil(kMeasured / feed));
  const auto skipped_steps = static_cast<int>(std::ceil(1.0 / feed));  // the start itself
  const int total = lead_steps + measure_steps;

  std::vector<double> force;
  double largest_change = 0.0;
  double before = 0.0;
  double mean = 0.0;
  double iterations = 0.0;
  for (int i = 0; i < total; ++i) {
    if (!wire.step(feed, 0.0)) return simulation_failed();
    const double now = wire.rod().handle_force();
    if (i > skipped_steps) {
      largest_change = std::max(largest_change, std::abs(now - before) * 1e-3 / dt);
    }
    before = now;
    iterations += wire.rod().iterations();
    if (i >= lead_steps) {
      force.push_back(now);
      mean += now / measure_steps;
    }
    if (i % 100 == 0) run.progress(static_cast<double>(i) / total);
  }
  const auto window = static_cast<std::size_t>(std::lround(kWindow / dt));
  const double rms = 1e3 * ripple(force, window);
  run.simulated("mean_force", mean, "N");
  run.simulated("ripple_rms", rms, "mN");
  run.simulated("largest_change", 1e3 * largest_change, "mN/ms");
  run.simulated("mean_iterations", iterations / total, "1");
  run.expected("ripple_rms", 0.0, "mN", "a continuous wire");
  run.check("ripple_rms", rms, kRippleBound, "mN");
  run.check("largest_change", 1e3 * largest_change, kChangeBound, "mN/ms");
  return base::Done{};
}

}  // namespace sim::validation
