// A hand without a plan: pushes, pulls, turns and reversals at random, and what came of it.
#pragma once

#include <cstdint>

#include "sim/dynamics/world.h"

namespace support {

struct CommandReport {
  int commands = 0;  // done
  std::int64_t steps = 0;
  bool diverged = false;
  bool finite = true;      // every node, every number observed
  double deepest = 0.0;    // mm any node's surface got beyond the wall
  double force_max = 0.0;  // N, contact force
  double force_p99 = 0.0;
  double handle_force_max = 0.0;                  // N, either way
  std::int64_t unconverged = 0;                   // steps with more than 5 mN left unbalanced
  std::int64_t in_contact = 0;                    // steps
  double inserted_min = 0.0, inserted_max = 0.0;  // mm
};

// `count` commands of 20 to 500 ms each: feed up to 80 mm/s either way, turn up to 360 degrees/s
// either way, or both. The vessel must be the world's. Stops when it diverges.
CommandReport run_random_commands(sim::World& world, const sim::Vessel& vessel,
                                  const sim::Instrument& instrument, int count, std::uint32_t seed);

}  // namespace support
