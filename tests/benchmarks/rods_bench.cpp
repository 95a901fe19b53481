// Time of one 1 ms step of the rod, wall query included, under a random hand (0.7 to 6.7 Hz, up to
// 100 mm/s and 400 deg/s). Guards the budget of the scene `heavy` (400 nodes, about 140 of them
// in contact): median at most 0.60 ms and 99th percentile at most 2.0 ms of thread CPU time.
//
//     rods_bench [--json] [--smoke]
//
// Runs of 3000 steps, median of five by thread CPU time; wall-clock time of the same run beside
// it. `--smoke` makes one short run of each, to see that it works.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <vector>

#include <time.h>

#include "tests/support/rod_scenes.h"

namespace {

using sim::scenes::LaidWire;

double clock_seconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Spread {
  double median = 0.0;  // ms
  double p99 = 0.0;
  double worst = 0.0;
};

Spread spread(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const auto at = [&times](double share) {
    return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
  };
  return {.median = at(0.5), .p99 = at(0.99), .worst = times.back()};
}

struct Outcome {
  bool heavy = false;
  int nodes = 0;
  double contacts = 0.0;    // mean per step
  double iterations = 0.0;  // mean per step
  int unconverged = 0;      // steps that left more than 5 mN
  int steps = 0;
  Spread cpu, wall;
  std::uint64_t state_hash = 0;
};

// FNV-1a over the state's bytes: the same on every run of the same build.
std::uint64_t hash(std::span<const std::byte> bytes) {
  std::uint64_t value = 14695981039346656037ULL;
  for (std::byte byte : bytes) {
    value ^= static_cast<std::uint64_t>(byte);
    value *= 1099511628211ULL;
  }
  return value;
}

Outcome measure(int nodes, bool heavy, int steps) {
  LaidWire scene(nodes, heavy);
  sim::RodInstrument& rod = scene.rod();
  Outcome outcome;
  outcome.heavy = heavy;
  outcome.steps = steps;
  std::vector<double> cpu;
  std::vector<double> wall;
  double axial = 0.0;
  double rotation = 0.0;
  double node_sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const sim::scenes::Hand hand = sim::scenes::random_hand(i * 1e-3);
    axial += 1e-3 * hand.feed;
    rotation += 1e-3 * hand.turn;
    const double cpu_start = clock_seconds(CLOCK_THREAD_CPUTIME_ID);
    const double wall_start = clock_seconds(CLOCK_MONOTONIC);
    const sim::RodStatus status = rod.step(axial, rotation);
    wall.push_back(1e3 * (clock_seconds(CLOCK_MONOTONIC) - wall_start));
    cpu.push_back(1e3 * (clock_seconds(CLOCK_THREAD_CPUTIME_ID) - cpu_start));
    if (status != sim::RodStatus::ok) {
      std::fprintf(stderr, "the scene diverged in step %d\n", i);
      break;
    }
    outcome.contacts += static_cast<double>(rod.contact_count()) / steps;
    outcome.iterations += static_cast<double>(rod.iterations()) / steps;
    node_sum += static_cast<double>(rod.nodes().size()) / steps;
    if (rod.residual() > 5e-3) ++outcome.unconverged;
  }
  outcome.nodes = static_cast<int>(node_sum + 0.5);
  outcome.cpu = spread(cpu);
  outcome.wall = spread(wall);
  std::vector<std::byte> state;
  rod.append_state(state);
  outcome.state_hash = hash(state);
  return outcome;
}

Outcome median_of(int runs, int nodes, bool heavy, int steps) {
  std::vector<Outcome> outcomes;
  for (int i = 0; i < runs; ++i) outcomes.push_back(measure(nodes, heavy, steps));
  std::sort(outcomes.begin(), outcomes.end(),
            [](const Outcome& a, const Outcome& b) { return a.cpu.median < b.cpu.median; });
  return outcomes[outcomes.size() / 2];
}

void print_text(const Outcome& o) {
  std::printf("%-5s %5d %8.1f   %6.3f %6.3f %6.3f   %6.3f %6.3f %6.3f   %5.3f %7.2f   %016llx\n",
              o.heavy ? "heavy" : "free", o.nodes, o.contacts, o.cpu.median, o.cpu.p99, o.cpu.worst,
              o.wall.median, o.wall.p99, o.wall.worst, o.iterations,
              100.0 * o.unconverged / o.steps, static_cast<unsigned long long>(o.state_hash));
}

void print_json(const Outcome& o, bool last) {
  std::printf(
      "  {\"scene\": \"%s\", \"nodes\": %d, \"contacts_mean\": %.2f, \"steps\": %d,\n"
      "   \"cpu_median_ms\": %.5f, \"cpu_p99_ms\": %.5f, \"cpu_worst_ms\": %.5f,\n"
      "   \"wall_median_ms\": %.5f, \"wall_p99_ms\": %.5f, \"wall_worst_ms\": %.5f,\n"
      "   \"iterations_mean\": %.4f, \"steps_over_5_mn\": %d, \"state_hash\": \"%016llx\"}%s\n",
      o.heavy ? "heavy" : "free", o.nodes, o.contacts, o.steps, o.cpu.median, o.cpu.p99,
      o.cpu.worst, o.wall.median, o.wall.p99, o.wall.worst, o.iterations, o.unconverged,
      static_cast<unsigned long long>(o.state_hash), last ? "" : ",");
}

}  // namespace

int main(int argc, char** argv) {
  bool json = false;
  bool smoke = false;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--json") == 0) {
      json = true;
    } else if (std::strcmp(argv[i], "--smoke") == 0) {
      smoke = true;
    } else {
      std::fprintf(stderr, "usage: rods_bench [--json] [--smoke]\n");
      return 2;
    }
  }
  if (json) {
    std::printf("[\n");
  } else {
    std::printf("ms per step                  CPU                    wall clock\n");
    std::printf(
        "scene nodes contacts   median    p99  worst   median    p99  worst   "
        "iter. > 5 mN %%   state\n");
  }
  for (bool heavy : {false, true}) {
    for (int nodes : {100, 200, 400}) {
      const Outcome outcome = median_of(smoke ? 1 : 5, nodes, heavy, smoke ? 50 : 3000);
      json ? print_json(outcome, heavy && nodes == 400) : print_text(outcome);
      std::fflush(stdout);
    }
  }
  if (json) std::printf("]\n");
  return 0;
}
