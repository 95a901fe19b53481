#include "app/devices/simulated_operator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sim/base/units.h"

namespace app {
namespace {

using namespace base::units;
using curricula::Step;

constexpr int kControlSteps = 10;       // the hand changes its mind 100 times a second
constexpr double kWobbleTime = 0.4;     // s over which unwanted turning changes
constexpr double kMaxFeed = 150.0;      // mm/s
constexpr double kMaxTurn = 900.0_deg;  // rad/s

// Speed of a minimum-jerk movement of unit length and duration at phase u in [0, 1]
// (Flash and Hogan 1985).
double minimum_jerk_speed(double u) {
  const double r = u * (1.0 - u);
  return 30.0 * r * r;
}

const std::array<Skill, 3>& skills() {
  static const std::array<Skill, 3> kSkills{{
      {.name = "expert",
       .feed_speed = 24.0,
       .turn_speed = 160.0_deg,
       .stroke = 60.0,
       .turn_stroke = 180.0_deg,
       .reaction = 0.22,
       .scatter = 0.02,
       .overshoot = 0.004,
       .hesitation_rate = 0.02,
       .hesitation = 0.4,
       .tremor = 0.02,
       .wobble = 2.0_deg,
       .slip = 0.2,
       .turn_slip = 0.4_deg,
       .learning = 0.04},
      {.name = "intermediate",
       .feed_speed = 17.0,
       .turn_speed = 115.0_deg,
       .stroke = 40.0,
       .turn_stroke = 120.0_deg,
       .reaction = 0.30,
       .scatter = 0.05,
       .overshoot = 0.012,
       .hesitation_rate = 0.08,
       .hesitation = 0.8,
       .tremor = 0.04,
       .wobble = 8.0_deg,
       .slip = 0.7,
       .turn_slip = 1.5_deg,
       .learning = 0.10},
      {.name = "novice",
       .feed_speed = 11.0,
       .turn_speed = 75.0_deg,
       .stroke = 22.0,
       .turn_stroke = 70.0_deg,
       .reaction = 0.42,
       .scatter = 0.12,
       .overshoot = 0.03,
       .hesitation_rate = 0.20,
       .hesitation = 1.3,
       .tremor = 0.08,
       .wobble = 20.0_deg,
       .slip = 1.6,
       .turn_slip = 5.0_deg,
       .learning = 0.18},
  }};
  return kSkills;
}

}  // namespace

std::optional<Skill> find_skill(const std::string& name) {
  for (const Skill& skill : skills()) {
    if (skill.name == name) return skill;
  }
  return std::nullopt;
}

SimulatedOperator::SimulatedOperator(const Skill& skill, std::uint64_t seed, int trial)
    : skill_(skill), random_(seed) {
  // practice: faster, straighter, calmer by the same power of the trial's number
  const double gain = std::pow(static_cast<double>(std::max(trial, 1)), skill.learning);
  const double day = std::exp(0.05 * normal());  // nobody is the same twice
  skill_.feed_speed *= gain * day;
  skill_.turn_speed *= gain * day;
  skill_.scatter /= gain;
  skill_.overshoot /= gain;
  skill_.hesitation_rate /= gain;
  skill_.tremor /= gain;
  skill_.wobble /= gain;
  skill_.slip /= gain;
  skill_.turn_slip /= gain;
  tremor_frequency_ = 8.0 + 4.0 * uniform();
}

// 53 random bits: the same on every platform, unlike the distributions of the standard library.
double SimulatedOperator::uniform() { return static_cast<double>(random_() >> 11) * 0x1.0p-53; }

double SimulatedOperator::normal() {  // Box and Muller (1958)
  const double u = std::max(uniform(), 0x1.0p-53);
  const double v = uniform();
  return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
}

// Plans the next submovement towards a target `distance` away.
void SimulatedOperator::plan(double time, double distance, bool turning, double tolerance) {
  const double stroke = turning ? skill_.turn_stroke : skill_.stroke;
  const double speed = turning ? skill_.turn_speed : skill_.feed_speed;
  const bool last = std::abs(distance) <= stroke;

  double length = last ? distance : std::copysign(stroke * (1.0 + 0.15 * normal()), distance);
  if (last) {
    // a long last reach lands off target; a short correction lands well
    const double error = skill_.overshoot + skill_.scatter * 0.5 * normal();
    length *= 1.0 + error;
    length += std::copysign(0.15 * tolerance, distance) * normal();
  }
  submovement_.distance = length;
  submovement_.turning = turning;
  submovement_.begun = time;
  submovement_.duration =
      std::max(0.25, std::abs(length) / speed * (1.0 + skill_.scatter * normal()));
  moving_ = true;

  if (uniform() < skill_.hesitation_rate * submovement_.duration) {
    const double pause = -skill_.hesitation * std::log(std::max(uniform(), 0x1.0p-53));
    submovement_.begun += pause;
  }
}

// Taking a new grip lets the shaft run back a little: quickly, and more in an unpractised hand.
void SimulatedOperator::plan_slip(double time) {
  const double mean = submovement_.turning ? skill_.turn_slip : skill_.slip;
  submovement_.distance = std::copysign(mean * (0.5 + uniform()), -submovement_.distance);
  submovement_.begun = time;
  submovement_.duration = 0.25;
  moving_ = true;
  slipping_ = true;
}

sim::HandleInput SimulatedOperator::next(const sim::Observation& seen,
                                         const ExerciseMonitor& monitor) {
  if (seen.step % kControlSteps != 0) return held_;
  held_ = {};
  const TaskState& task = monitor.task();
  if (task.step_index >= static_cast<int>(monitor.descriptions().size())) return held_;

  const double time = static_cast<double>(seen.step) * sim::kStepLength;
  const Step& step = monitor.descriptions()[static_cast<std::size_t>(task.step_index)];
  if (task.step_index != step_index_) {
    step_index_ = task.step_index;
    moving_ = false;
    slipping_ = false;
    busy_until_ = time + skill_.reaction * (1.0 + 0.2 * std::abs(normal()));
  }
  if (step.kind == Step::Kind::hold || time < busy_until_) return held_;

  const bool turning = step.kind == Step::Kind::rotate;
  const double at = turning ? seen.handle_rotation : seen.handle_axial;
  if (!moving_) {
    const double distance = step.target - at;
    if (std::abs(distance) <= 0.6 * step.tolerance) return held_;  // there: keep still
    plan(time, distance, turning, step.tolerance);
  }

  const double phase = (time - submovement_.begun) / submovement_.duration;
  if (phase >= 1.0) {
    const bool far = std::abs(step.target - at) > 3.0 * step.tolerance;
    if (!slipping_ && far) {
      plan_slip(time);
      return held_;
    }
    moving_ = false;
    slipping_ = false;
    busy_until_ = time + 0.5 * skill_.reaction;  // look, take a new grip
    return held_;
  }
  if (phase < 0.0) return held_;  // hesitating

  const double speed = submovement_.distance / submovement_.duration * minimum_jerk_speed(phase);
  tremor_phase_ += 2.0 * std::numbers::pi * tremor_frequency_ * kControlSteps * sim::kStepLength;
  const double tremor = skill_.tremor * 2.0 * std::numbers::pi * tremor_frequency_ *
                        std::cos(tremor_phase_) * (1.0 + 0.3 * normal());
  if (turning) {
    held_.turn = std::clamp(speed + tremor * 1.0_deg, -kMaxTurn, kMaxTurn);
  } else {
    const double mix = kControlSteps * sim::kStepLength / kWobbleTime;
    wobble_ += -mix * wobble_ + std::sqrt(2.0 * mix) * skill_.wobble * normal();
    held_.feed = std::clamp(speed + tremor, -kMaxFeed, kMaxFeed);
    held_.turn = wobble_;
  }
  return held_;
}

}  // namespace app
