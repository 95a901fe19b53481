#include "tests/support/random_commands.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "sim/base/units.h"

namespace support {
namespace {

using namespace base::units;

class Hand {
 public:
  explicit Hand(std::uint32_t seed) : random_(seed) {}

  // A command and how many steps it lasts.
  std::pair<sim::HandleInput, int> next() {
    const double kind = uniform(0.0, 1.0);
    sim::HandleInput input;
    if (kind < 0.8) input.feed = uniform(-60.0, 80.0);  // forward on the whole, or it never arrives
    if (kind > 0.5) input.turn = uniform(-360.0_deg, 360.0_deg);
    if (kind > 0.95) input = {-last_.feed, -last_.turn};
    last_ = input;
    return {input, static_cast<int>(uniform(20.0, 500.0))};
  }

 private:
  // not std::uniform_real_distribution, whose numbers differ between libraries
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }

  std::mt19937 random_;
  sim::HandleInput last_;
};

double deepest_node(const sim::World& world, const sim::Vessel& vessel, double radius,
                    std::vector<sim::WallSample>& samples) {
  const auto nodes = world.nodes();
  samples.resize(nodes.size());
  vessel.wall->sample(nodes, samples);
  double deepest = 0.0;
  for (const sim::WallSample& sample : samples) {
    deepest = std::max(deepest, radius - sample.distance);
  }
  return deepest;
}

bool all_finite(const sim::World& world) {
  const sim::Observation& seen = world.observation();
  bool finite = std::isfinite(seen.handle_force) && std::isfinite(seen.handle_torque) &&
                std::isfinite(seen.contact_force) && std::isfinite(seen.contact_load) &&
                seen.tip.allFinite() && seen.tip_direction.allFinite();
  for (const sim::Vec3& node : world.nodes()) finite = finite && node.allFinite();
  return finite;
}

}  // namespace

CommandReport run_random_commands(sim::World& world, const sim::Vessel& vessel,
                                  const sim::Instrument& instrument, int count,
                                  std::uint32_t seed) {
  CommandReport report;
  Hand hand(seed);
  std::vector<sim::WallSample> samples;
  std::vector<double> forces;
  report.inserted_min = report.inserted_max = world.observation().inserted_length;
  for (; report.commands < count; ++report.commands) {
    const auto [input, steps] = hand.next();
    for (int i = 0; i < steps; ++i) {
      if (world.step(input) != sim::StepStatus::ok) {
        report.diverged = true;
        return report;
      }
      const sim::Observation& seen = world.observation();
      ++report.steps;
      report.finite = report.finite && all_finite(world);
      report.deepest = std::max(
          report.deepest, deepest_node(world, vessel, instrument.outer_diameter / 2.0, samples));
      report.handle_force_max = std::max(report.handle_force_max, std::abs(seen.handle_force));
      report.unconverged += seen.solver_residual > 5.0_mN;
      report.in_contact += seen.contact_count > 0;
      report.inserted_min = std::min(report.inserted_min, seen.inserted_length);
      report.inserted_max = std::max(report.inserted_max, seen.inserted_length);
      forces.push_back(seen.contact_force);
    }
  }
  std::sort(forces.begin(), forces.end());
  if (!forces.empty()) {
    report.force_max = forces.back();
    report.force_p99 = forces[forces.size() * 99 / 100];
  }
  return report;
}

}  // namespace support
