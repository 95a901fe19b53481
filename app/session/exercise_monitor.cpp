#include "app/session/exercise_monitor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "sim/base/units.h"

namespace app {
namespace {

using namespace base::units;
using assessment::EndReason;
using assessment::Severity;
using curricula::Consequence;
using curricula::Step;

constexpr double kMovingFeed = 1.0;       // mm/s, above this the handle counts as moving
constexpr double kMovingTurn = 5.0_deg;   // rad/s
constexpr double kHitOn = 0.10;           // N, a wall hit begins
constexpr double kHitOff = 0.05;          // N, and ends
constexpr double kHitSpacing = 0.2;       // s between two hits
constexpr std::size_t kMaxEvents = 4096;  // room reserved, so that observing rarely allocates

assessment::StepKind kind_of(const Step& step) {
  switch (step.kind) {
    case Step::Kind::rotate:
      return assessment::StepKind::rotate;
    case Step::Kind::hold:
      return assessment::StepKind::hold;
    default:
      return assessment::StepKind::translate;
  }
}

Severity severity_of(Consequence consequence) {
  switch (consequence) {
    case Consequence::mark:
      return Severity::mark;
    case Consequence::critical_error:
      return Severity::critical;
    default:
      return Severity::fail;
  }
}

}  // namespace

ExerciseMonitor::ExerciseMonitor(const curricula::Exercise& exercise)
    : time_limit_(exercise.attempt.time_limit), descriptions_(curricula::unroll(exercise.steps)) {
  for (const Step& step : descriptions_) {
    steps_.push_back({.id = step.id,
                      .kind = kind_of(step),
                      .target = step.kind == Step::Kind::hold ? step.seconds : step.target,
                      .tolerance = step.tolerance});
  }
  for (const curricula::Limit& limit : exercise.limits) {
    limits_.push_back({limit.metric, 0.0, limit.bound, limit.on_breach, false, limit.comparison});
  }
  events_.reserve(kMaxEvents);
}

void ExerciseMonitor::add_event(double time, const char* code, Severity severity,
                                std::string detail, double value) {
  events_.push_back({time, code, severity, std::move(detail), value});
}

void ExerciseMonitor::note(double time, const char* code) {
  if (task_.ended) return;
  add_event(time, code, Severity::info, "", 0.0);
}

double ExerciseMonitor::value_of(const Step& step, const sim::Observation& observation) const {
  switch (step.kind) {
    case Step::Kind::rotate:
      return observation.handle_rotation;
    case Step::Kind::hold:
      return task_.held;
    default:
      return observation.handle_axial;
  }
}

void ExerciseMonitor::begin_step(double time, const sim::Observation& observation) {
  const auto index = static_cast<std::size_t>(task_.step_index);
  steps_[index].started = time;
  // holding still begins with the step itself, reaching a mark only when it is reached
  within_since_ = steps_[index].kind == assessment::StepKind::hold ? time : -1.0;
  task_.held = 0.0;
  task_.step_start = value_of(descriptions_[index], observation);
  hold_origin_axial_ = observation.handle_axial;
  hold_origin_rotation_ = observation.handle_rotation;
  add_event(time, "step_started", Severity::info, steps_[index].id, steps_[index].target);
}

void ExerciseMonitor::finish_step(double time, double residual) {
  assessment::TrialStep& step = steps_[static_cast<std::size_t>(task_.step_index)];
  step.ended = time;
  step.residual = residual;
  add_event(time, "step_done", Severity::info, step.id, residual);
  ++task_.step_index;
}

void ExerciseMonitor::observe(const sim::Observation& observation, const sim::HandleInput& input) {
  if (task_.ended) return;
  const double time = static_cast<double>(observation.step) * sim::kStepLength;

  if (!task_.started &&
      (std::abs(input.feed) > kMovingFeed || std::abs(input.turn) > kMovingTurn)) {
    task_.started = true;
    first_motion_ = time - sim::kStepLength;
    add_event(first_motion_, "first_motion", Severity::info, "", 0.0);
  }
  if (!first_step_begun_) {
    first_step_begun_ = true;
    begin_step(0.0, observation);
  }
  if (task_.started) task_.elapsed = time - first_motion_;

  advance_step(observation, time);
  check_limits(observation, time);
  if (task_.ended) return;
  if (task_.step_index == static_cast<int>(steps_.size())) {
    end(EndReason::completed, time);
  } else if (task_.elapsed >= time_limit_) {
    add_event(time, "timeout", Severity::fail, "", time_limit_);
    end(EndReason::timeout, time);
  }
}

// A step is done when the handle has stayed within the tolerance for the hold time.
void ExerciseMonitor::advance_step(const sim::Observation& observation, double time) {
  const Step& step = descriptions_[static_cast<std::size_t>(task_.step_index)];
  bool within;
  double needed;
  double residual;
  if (step.kind == Step::Kind::hold) {
    const double moved =
        std::max(std::abs(observation.handle_axial - hold_origin_axial_),
                 std::abs(observation.handle_rotation - hold_origin_rotation_) / kHoldTurnPerMm);
    within = moved <= step.tolerance;
    needed = step.seconds;
    residual = moved;
    if (!within) {
      hold_origin_axial_ = observation.handle_axial;
      hold_origin_rotation_ = observation.handle_rotation;
    }
  } else {
    residual = value_of(step, observation) - step.target;
    within = std::abs(residual) <= step.tolerance;
    needed = step.hold;
  }

  if (!within) {
    within_since_ = -1.0;
    task_.held = 0.0;
  } else {
    if (within_since_ < 0.0) within_since_ = time;
    task_.held = time - within_since_;
  }
  task_.step_value = value_of(step, observation);

  // half a step of slack: times are multiples of the step, so 1 s means 1000 steps, not 1001
  if (within && task_.held >= needed - 0.5 * sim::kStepLength) {
    finish_step(time, residual);
    if (task_.step_index < static_cast<int>(steps_.size())) begin_step(time, observation);
  }
}

void ExerciseMonitor::check_limits(const sim::Observation& observation, double time) {
  force_max_ = std::max(force_max_, observation.contact_force);
  handle_force_max_ = std::max(handle_force_max_, std::abs(observation.handle_force));
  torque_max_ = std::max(torque_max_, std::abs(observation.handle_torque));
  impulse_ += observation.contact_force * sim::kStepLength;
  if (!in_hit_ && observation.contact_force >= kHitOn &&
      (last_hit_ < 0.0 || time - last_hit_ >= kHitSpacing)) {
    in_hit_ = true;
    last_hit_ = time;
    ++hits_;
    add_event(time, "wall_hit", Severity::info, "", observation.contact_force);
  } else if (in_hit_ && observation.contact_force <= kHitOff) {
    in_hit_ = false;
  }

  for (LimitState& limit : limits_) {
    limit.value = watched_value(limit.metric);
    if (limit.breached || assessment::holds(limit.value, limit.comparison, limit.bound)) continue;
    limit.breached = true;
    add_event(time, "limit_breached", severity_of(limit.on_breach), limit.metric, limit.value);
    if (limit.on_breach == Consequence::stop) {
      end(EndReason::limit, time);
      return;
    }
  }
}

double ExerciseMonitor::watched_value(const std::string& metric) const {
  if (metric == "force_max_n") return force_max_;
  if (metric == "handle_force_max_n") return handle_force_max_;
  if (metric == "torque_max_n_mm") return torque_max_;
  if (metric == "contact_impulse_n_s") return impulse_;
  if (metric == "wall_hits") return hits_;
  return task_.elapsed;  // time_s; the checker admits no other metric as a limit
}

void ExerciseMonitor::end(EndReason reason, double time) {
  if (task_.ended) return;
  task_.ended = true;
  task_.end_reason = reason;
  add_event(time, "ended", Severity::info, assessment::word(reason), 0.0);
}

}  // namespace app
