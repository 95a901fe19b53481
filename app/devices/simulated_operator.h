// A scripted controller with a skill level, so that every exercise can be run without a person.
// It is not a model of anyone: it moves the handle the way motor control describes it (a reaction
// delay, submovements with bell-shaped speed that land near the target and are corrected, tremor,
// hesitation) and gets better with practice by a power law. Its trials are labelled as simulated
// everywhere.
//
// Tremor: physiological hand tremor lies at 8 to 12 Hz (Elble and Koller 1990). Bell-shaped speed:
// the minimum-jerk profile of Flash and Hogan (1985).
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>

#include "app/devices/operator.h"

namespace app {

struct Skill {
  std::string name;              // expert | intermediate | novice
  double feed_speed = 0.0;       // mm/s, mean over a submovement
  double turn_speed = 0.0;       // rad/s, mean over a submovement
  double stroke = 0.0;           // mm the hand moves before it takes a new grip
  double turn_stroke = 0.0;      // rad likewise
  double reaction = 0.0;         // s between seeing and moving
  double scatter = 0.0;          // relative error of a submovement's length, one SD
  double overshoot = 0.0;        // relative bias of the last submovement towards too far
  double hesitation_rate = 0.0;  // 1/s of movement
  double hesitation = 0.0;       // s, mean
  double tremor = 0.0;           // mm, SD of the tremor's travel; turning: the same in degrees
  double wobble = 0.0;           // rad/s, SD of unwanted turning while feeding
  double slip = 0.0;             // mm the shaft runs back while the hand takes a new grip, mean
  double turn_slip = 0.0;        // rad likewise
  double learning = 0.0;         // exponent b of speed ~ trial^b, and of 1 / error
};

// Null when there is no such skill. Names: expert, intermediate, novice.
std::optional<Skill> find_skill(const std::string& name);

class SimulatedOperator final : public Operator {
 public:
  // `trial`: 1 for the first trial of this operator; later ones are faster and cleaner.
  SimulatedOperator(const Skill& skill, std::uint64_t seed, int trial);

  sim::HandleInput next(const sim::Observation& seen, const ExerciseMonitor& monitor) override;

 private:
  struct Submovement {
    double distance = 0.0;  // mm or rad, signed
    double duration = 0.0;  // s
    double begun = 0.0;     // s
    bool turning = false;
  };

  void plan(double time, double distance, bool turning, double tolerance);
  void plan_slip(double time);
  double normal();
  double uniform();

  Skill skill_;
  std::mt19937_64 random_;
  int step_index_ = -1;
  double busy_until_ = 0.0;  // s: reacting, hesitating or regripping until then
  bool moving_ = false;
  bool slipping_ = false;
  Submovement submovement_;
  double tremor_phase_ = 0.0;
  double tremor_frequency_ = 10.0;  // Hz
  double wobble_ = 0.0;             // rad/s, slowly varying
  sim::HandleInput held_;           // what the hand does until the next control tick
};

}  // namespace app
