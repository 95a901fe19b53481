// Recordings made by hand: the handle follows a list of moves at constant speed, the tip goes
// straight along x as far as the handle is fed.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "assessment/trial.h"

namespace assessment {

class TrialBuilder {
 public:
  TrialBuilder() { add_sample(); }

  // Feeds by `distance` mm at `speed` mm/s (both positive or negative through the distance).
  TrialBuilder& feed(double distance, double speed) {
    return move(distance, 0.0, std::abs(distance) / speed);
  }
  TrialBuilder& turn_deg(double angle_deg, double speed_deg) {
    return move(0.0, angle_deg * std::numbers::pi / 180.0, std::abs(angle_deg) / speed_deg);
  }
  TrialBuilder& wait(double seconds) { return move(0.0, 0.0, seconds); }

  TrialBuilder& begin_step(const std::string& id, StepKind kind, double target, double tolerance) {
    trial_.steps.push_back(
        {.id = id, .kind = kind, .target = target, .tolerance = tolerance, .started = now()});
    return *this;
  }
  TrialBuilder& end_step() {
    trial_.steps.back().ended = now();
    return *this;
  }
  double now() const { return trial_.samples.back().time; }

  RecordedTrial done() {
    trial_.exercise_id = "test";
    trial_.end_reason = EndReason::completed;
    trial_.end_time = now();
    return trial_;
  }

 private:
  TrialBuilder& move(double axial, double rotation, double seconds) {
    const int count = static_cast<int>(std::lround(seconds * kSampleRate));
    const double axial_from = axial_, rotation_from = rotation_;
    for (int i = 1; i <= count; ++i) {
      const double share = static_cast<double>(i) / count;
      axial_ = axial_from + share * axial;
      rotation_ = rotation_from + share * rotation;
      add_sample();
    }
    return *this;
  }
  void add_sample() {
    Sample sample;
    sample.time = static_cast<double>(trial_.samples.size()) / kSampleRate;
    sample.tip = {axial_, 0.0, 0.0};
    sample.tip_direction = {1.0, 0.0, 0.0};
    sample.handle_axial = axial_;
    sample.handle_rotation = rotation_;
    sample.inserted_length = axial_;
    trial_.samples.push_back(sample);
  }

  RecordedTrial trial_;
  double axial_ = 0.0, rotation_ = 0.0;
};

// The linear task at 50 mm/s: waits 1 s, feeds to 350, back to 150, to 350, each with 1 s of hold.
inline RecordedTrial linear_trial() {
  return TrialBuilder()
      .begin_step("feed-1", StepKind::translate, 350.0, 2.0)
      .wait(1.0)
      .feed(350.0, 50.0)
      .wait(1.0)
      .end_step()
      .begin_step("retract", StepKind::translate, 150.0, 2.0)
      .feed(-200.0, 50.0)
      .wait(1.0)
      .end_step()
      .begin_step("feed-2", StepKind::translate, 350.0, 2.0)
      .feed(200.0, 50.0)
      .wait(1.0)
      .end_step()
      .done();
}

}  // namespace assessment
