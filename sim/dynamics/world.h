// The simulated world of one trial: one instrument in one vessel, stepped at 1 kHz.
//
//     inputs -> find contacts -> solve instrument -> rigid bodies -> observe
//
// A subclass of Bullet's dynamics world whose internal single step is overridden; Bullet keeps
// the rigid bodies, the broad phase and the debug drawing. The step allocates, locks and logs
// nothing, and the same build with the same inputs gives the same state, bit for bit.
//
// Not here: who steers, what counts as success, what is stored.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sim/anatomy/vessel.h"
#include "sim/instrument/instrument.h"
#include "sim/math/vec3.h"

namespace sim {

inline constexpr double kStepLength = 1e-3;  // s

// What is built once for a trial. Vessel and instrument must outlive the world.
struct Scenario {
  const Vessel* vessel = nullptr;
  const Instrument* instrument = nullptr;
  double start_inserted = 0.0;  // mm of instrument beyond the access when the trial starts
};

// What the hand does during one step: the velocity of the handle. The world integrates it, and
// stops the handle where the instrument ends (fully withdrawn, or fully inserted).
struct HandleInput {
  double feed = 0.0;  // mm/s, positive pushes in
  double turn = 0.0;  // rad/s, positive is clockwise seen by the operator
};

enum class StepStatus { ok, diverged };

// What can be seen and felt after a step.
struct Observation {
  std::int64_t step = 0;           // steps done; time is step * kStepLength
  double handle_axial = 0.0;       // mm, cumulative since the start of the trial
  double handle_rotation = 0.0;    // rad, cumulative
  double inserted_length = 0.0;    // mm beyond the access
  Vec3 tip = Vec3::Zero();         // mm
  Vec3 tip_direction = Vec3::UnitZ();
  double handle_force = 0.0;       // N, positive: the instrument resists being pushed in
  double handle_torque = 0.0;      // N mm, positive: it resists being turned clockwise
  double contact_force = 0.0;      // N, largest |sum of wall reactions| over any 6 mm
  double contact_load = 0.0;       // N, sum of the normal loads
  int contact_count = 0;           // nodes touching the wall
  int solver_iterations = 0;
  double solver_residual = 0.0;    // N
};

// Time of each phase of the last step, s.
struct StepProfile {
  double find_contacts = 0.0;
  double solve_instrument = 0.0;
  double rigid_bodies = 0.0;
  double observe = 0.0;
};

class World {
 public:
  // Throws std::invalid_argument when the scenario is incomplete or impossible.
  explicit World(const Scenario& scenario);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  // One step of kStepLength. After `diverged` the world stays as it is and must not be stepped.
  StepStatus step(const HandleInput& input);

  const Observation& observation() const;
  const StepProfile& profile() const;

  // Nodes from the access to the tip, mm, and the wall's reaction on each, N. Valid until the
  // next step.
  std::span<const Vec3> nodes() const;
  std::span<const Vec3> node_forces() const;

  // Appends the full state (positions, velocities, twists, friction memory) byte by byte: what a
  // hash of the state is taken over.
  void append_state(std::vector<std::byte>& bytes) const;

 private:
  class Dynamics;  // the Bullet subclass, so that Bullet's headers stay in one file
  std::unique_ptr<Dynamics> dynamics_;
};

}  // namespace sim
