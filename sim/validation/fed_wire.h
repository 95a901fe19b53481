// A wire fed through its sheath into a tube with one bend: the scene of the cases that look at
// what the hand feels.
#pragma once

#include "sim/anatomy/vessel.h"
#include "sim/dynamics/rod_instrument.h"
#include "sim/validation/analytic_walls.h"
#include "sim/validation/case_run.h"

namespace sim::validation {

// The parameters of the scene: mu, ei, gj, radius, angle, element_length, dt.
std::vector<ParameterDefinition> fed_wire_parameters();

class FedWire {
 public:
  explicit FedWire(const CaseRun& run) : FedWire(run, run["element_length"]) {}
  FedWire(const CaseRun& run, double element_length);  // mm, whatever the parameter says

  // Moves the handle by that much in one step; false when the simulation failed.
  bool step(double feed, double turn);

  double steps_per_second() const { return 1.0 / time_step_; }
  double time_step() const { return time_step_; }
  double bend_end() const { return bend_end_; }  // mm of axis from the access
  const RodInstrument& rod() const { return rod_; }

 private:
  static TubeWall make_tube(double radius, double angle);

  double time_step_;
  double bend_end_;
  TubeWall tube_;
  RodInstrument rod_;
  double axial_ = 0.0;
  double rotation_ = 0.0;
};

}  // namespace sim::validation
