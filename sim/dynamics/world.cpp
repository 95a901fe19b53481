#include "sim/dynamics/world.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <btBulletDynamicsCommon.h>

#include "sim/base/require.h"
#include "sim/dynamics/rod_instrument.h"

namespace sim {
namespace {

// mm that can be inserted: the instrument ends, or the vessel does.
double reach(const Scenario& scenario) {
  return std::min(scenario.instrument->length, scenario.vessel->centreline.back().arc_length);
}

const Scenario& checked(const Scenario& scenario) {
  base::require(scenario.vessel != nullptr && scenario.vessel->wall != nullptr,
                "a scenario needs a vessel with a wall");
  base::require(scenario.instrument != nullptr, "a scenario needs an instrument");
  base::require(scenario.vessel->centreline.size() >= 2, "a vessel needs a centreline");
  base::require(std::isfinite(scenario.start_inserted) && scenario.start_inserted >= 0.0,
                "a trial cannot start with less than nothing inserted");
  base::require(scenario.start_inserted <= reach(scenario),
                "a trial cannot start beyond the end of the instrument or the vessel");
  return scenario;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// What Bullet's world is made of, in the order it wants them built. A base class of the world, so
// that they outlive it.
struct BulletParts {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broad_phase;
  btSequentialImpulseConstraintSolver constraint_solver;
};

}  // namespace

class World::Dynamics : private BulletParts, public btDiscreteDynamicsWorld {
 public:
  explicit Dynamics(const Scenario& scenario)
      : btDiscreteDynamicsWorld(&dispatcher, &broad_phase, &constraint_solver, &configuration),
        rod_(*scenario.instrument, scenario.vessel->access, scenario.vessel->wall.get(),
             scenario.start_inserted),
        start_inserted_(scenario.start_inserted),
        reach_(reach(scenario)) {
    setGravity(btVector3(0.0, 0.0, 0.0));  // what is in the blood floats
    move_rigid_bodies(kStepLength);        // Bullet sizes its buffers the first time
    observe();
  }

  StepStatus step(const HandleInput& input) {
    assert(status_ == StepStatus::ok && "a diverged world must not be stepped");
    input_ = input;
    internalSingleStepSimulation(kStepLength);
    return status_;
  }

  const Observation& observation() const { return observation_; }
  const StepProfile& profile() const { return profile_; }
  std::span<const Vec3> nodes() const { return rod_.nodes().subspan(rod_.first_visible()); }
  std::span<const Vec3> node_forces() const {
    return rod_.node_forces().subspan(rod_.first_visible());
  }

  void append_state(std::vector<std::byte>& bytes) const {
    rod_.append_state(bytes);
    const auto steps = std::as_bytes(std::span(&observation_.step, 1));
    bytes.insert(bytes.end(), steps.begin(), steps.end());
  }

 protected:
  // The step, as a list of phases.
  void internalSingleStepSimulation(btScalar step_length) override {
    move_handle(step_length);
    solve_instrument();  // asks for contacts while it iterates, and times that apart
    if (status_ != StepStatus::ok) return;
    move_rigid_bodies(step_length);
    ++observation_.step;
    observe();
  }

 private:
  void move_handle(double step_length) {
    const double axial = handle_axial_ + input_.feed * step_length;
    handle_axial_ = std::clamp(axial, -start_inserted_, reach_ - start_inserted_);
    handle_rotation_ += input_.turn * step_length;
  }

  void solve_instrument() {
    const auto start = std::chrono::steady_clock::now();
    const bool ok = rod_.step(handle_axial_, handle_rotation_) == RodStatus::ok;
    if (!ok || !rod_.tip().allFinite()) status_ = StepStatus::diverged;
    profile_.find_contacts = rod_.find_contacts_time();
    profile_.solve_instrument = seconds_since(start) - profile_.find_contacts;
  }

  // Bullet's own step, for whatever floats in the vessel.
  void move_rigid_bodies(double step_length) {
    const auto start = std::chrono::steady_clock::now();
    saveKinematicState(step_length);
    applyGravity();
    btDiscreteDynamicsWorld::internalSingleStepSimulation(step_length);
    synchronizeMotionStates();
    clearForces();
    profile_.rigid_bodies = seconds_since(start);
  }

  void observe() {
    const auto start = std::chrono::steady_clock::now();
    observation_.handle_axial = handle_axial_;
    observation_.handle_rotation = handle_rotation_;
    observation_.inserted_length = rod_.inserted_length();
    observation_.tip = rod_.tip();
    observation_.tip_direction = rod_.tip_direction();
    observation_.handle_force = rod_.handle_force();
    observation_.handle_torque = rod_.handle_torque();
    observation_.contact_force = rod_.contact_force();
    observation_.contact_load = rod_.contact_load();
    observation_.contact_count = rod_.contact_count();
    observation_.solver_iterations = rod_.iterations();
    observation_.solver_residual = rod_.residual();
    profile_.observe = seconds_since(start);
  }

  RodInstrument rod_;
  double start_inserted_, reach_;  // mm
  HandleInput input_;
  double handle_axial_ = 0.0, handle_rotation_ = 0.0;  // since the start of the trial
  StepStatus status_ = StepStatus::ok;
  Observation observation_;
  StepProfile profile_;
};

World::World(const Scenario& scenario) : dynamics_(std::make_unique<Dynamics>(checked(scenario))) {}
World::~World() = default;

StepStatus World::step(const HandleInput& input) { return dynamics_->step(input); }
const Observation& World::observation() const { return dynamics_->observation(); }
const StepProfile& World::profile() const { return dynamics_->profile(); }
std::span<const Vec3> World::nodes() const { return dynamics_->nodes(); }
std::span<const Vec3> World::node_forces() const { return dynamics_->node_forces(); }
void World::append_state(std::vector<std::byte>& bytes) const { dynamics_->append_state(bytes); }

}  // namespace sim
