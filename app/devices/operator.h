// Who or what steers a trial, apart from a person at a console: one interface for simulated
// operators and for recordings that are played again.
#pragma once

#include "app/session/exercise_monitor.h"
#include "sim/dynamics/world.h"

namespace app {

class Operator {
 public:
  virtual ~Operator() = default;

  // What the hand does during the next step, given what could be seen and felt after the last.
  virtual sim::HandleInput next(const sim::Observation& seen, const ExerciseMonitor& monitor) = 0;
};

}  // namespace app
