#include "assessment/metrics/signals.h"

#include <algorithm>
#include <cmath>

#include "assessment/motion/low_pass.h"

namespace assessment {
namespace {

bool usable(const Sample& sample) {
  const auto finite = [](double v) { return std::isfinite(v); };
  return finite(sample.time) && finite(sample.tip[0]) && finite(sample.tip[1]) &&
         finite(sample.tip[2]) && finite(sample.handle_axial) && finite(sample.handle_rotation) &&
         finite(sample.handle_force) && finite(sample.handle_torque) &&
         finite(sample.contact_force);
}

bool usable(std::span<const Sample> samples) {
  if (samples.size() < 2 || !usable(samples[0])) return false;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (!usable(samples[i]) || !(samples[i].time > samples[i - 1].time)) return false;
  }
  return true;
}

std::vector<Point> low_passed_tip(std::span<const Sample> samples) {
  std::vector<Point> points(samples.size());
  std::vector<double> coordinate(samples.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < samples.size(); ++i) coordinate[i] = samples[i].tip[axis];
    const std::vector<double> smooth = low_pass(coordinate, kSampleRate);
    for (std::size_t i = 0; i < samples.size(); ++i) points[i][axis] = smooth[i];
  }
  return points;
}

}  // namespace

std::optional<double> first_motion(std::span<const Sample> samples) {
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Sample& before = samples[i - 1];
    const Sample& after = samples[i];
    const double duration = after.time - before.time;
    if (std::abs(after.handle_axial - before.handle_axial) > kMovingSpeed * duration ||
        std::abs(after.handle_rotation - before.handle_rotation) > kTurningSpeed * duration) {
      return before.time;
    }
  }
  return std::nullopt;
}

bool all_steps_done(const RecordedTrial& trial) {
  return std::all_of(trial.steps.begin(), trial.steps.end(),
                     [](const TrialStep& step) { return step.done(); });
}

std::span<const TrialStep> Signals::begun() const {
  const auto& steps = trial->steps;
  const auto undone =
      std::find_if(steps.begin(), steps.end(), [](const TrialStep& step) { return !step.done(); });
  const auto count = static_cast<std::size_t>(undone - steps.begin());
  return std::span(steps).first(std::min(count + 1, steps.size()));
}

IntervalRange Signals::intervals(const TrialStep& step) const {
  // the first interval whose middle is at or after the given time
  const auto position = [this](double time) {
    std::size_t low = 0, high = times.size() - 1;
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (0.5 * (times[middle] + times[middle + 1]) < time) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  };
  return {position(step.started), position(end_of(step))};
}

std::optional<Signals> derive_signals(const RecordedTrial& trial) {
  const auto& samples = trial.samples;
  if (!usable(samples)) return std::nullopt;
  Signals signals;
  signals.trial = &trial;
  signals.times.reserve(samples.size());
  for (const Sample& sample : samples) signals.times.push_back(sample.time);
  signals.tip = low_passed_tip(samples);
  signals.tip_speed = speeds(signals.tip, signals.times);
  signals.turn.reserve(samples.size() - 1);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    signals.turn.push_back(samples[i].handle_rotation - samples[i - 1].handle_rotation);
  }
  signals.first_motion = first_motion(samples);
  signals.end = !trial.steps.empty() && all_steps_done(trial) ? trial.steps.back().ended
                                                              : signals.times.back();
  return signals;
}

}  // namespace assessment
