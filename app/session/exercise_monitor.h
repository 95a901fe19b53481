// Watches one trial: which step is on, how far it is, which limits are broken, when it ends.
// A pure function of the exercise and the observations, so that a replay judges the same.
#pragma once

#include <string>
#include <vector>

#include "assessment/trial.h"
#include "curricula/curriculum.h"
#include "sim/dynamics/world.h"

namespace app {

// A limit as the console shows it.
struct LimitState {
  std::string metric;
  double value = 0.0;  // so far
  double bound = 0.0;
  curricula::Consequence on_breach = curricula::Consequence::mark;
  bool breached = false;
  assessment::Comparison comparison = assessment::Comparison::less_equal;
};

// In a hold step, so much turning counts like one millimetre of feeding.
inline constexpr double kHoldTurnPerMm = 0.0174532925199433;  // rad, one degree

// The task as the console shows it.
struct TaskState {
  int step_index = 0;       // into steps(); == steps().size() when all are done
  double step_value = 0.0;  // handle position of the current step, mm or rad; hold: s held
  double step_start = 0.0;  // the value when the step began
  double held = 0.0;        // s within the tolerance so far
  double elapsed = 0.0;     // s since the first handle motion, 0 before
  bool started = false;     // the handle has moved
  bool ended = false;
  assessment::EndReason end_reason = assessment::EndReason::aborted;
};

class ExerciseMonitor {
 public:
  explicit ExerciseMonitor(const curricula::Exercise& exercise);

  // After each step of the world. Events that happened are appended to events().
  void observe(const sim::Observation& observation, const sim::HandleInput& input);
  void end(assessment::EndReason reason, double time);  // aborted from outside, diverged
  void note(double time, const char* code);             // an event from outside: paused, resumed

  const TaskState& task() const { return task_; }
  const std::vector<assessment::TrialStep>& steps() const { return steps_; }
  const std::vector<curricula::Step>& descriptions() const { return descriptions_; }
  const std::vector<LimitState>& limits() const { return limits_; }
  const std::vector<assessment::Event>& events() const { return events_; }

 private:
  void begin_step(double time, const sim::Observation& observation);
  void advance_step(const sim::Observation& observation, double time);
  void finish_step(double time, double residual);
  void check_limits(const sim::Observation& observation, double time);
  double value_of(const curricula::Step& step, const sim::Observation& observation) const;
  double watched_value(const std::string& metric) const;
  void add_event(double time, const char* code, assessment::Severity severity, std::string detail,
                 double value);

  double time_limit_;
  std::vector<curricula::Step> descriptions_;  // unrolled
  std::vector<assessment::TrialStep> steps_;
  std::vector<LimitState> limits_;
  std::vector<assessment::Event> events_;
  TaskState task_;
  bool first_step_begun_ = false;
  double first_motion_ = 0.0;
  double within_since_ = -1.0;  // time the handle came within the tolerance, or negative
  double hold_origin_axial_ = 0.0;
  double hold_origin_rotation_ = 0.0;

  // what the limits watch, so far
  double force_max_ = 0.0;
  double handle_force_max_ = 0.0;
  double torque_max_ = 0.0;
  double impulse_ = 0.0;
  int hits_ = 0;
  bool in_hit_ = false;
  double last_hit_ = -1.0;
};

}  // namespace app
