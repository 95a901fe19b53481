// What several metrics need from a recording, derived once: the low-passed path of the tip, speeds,
// when the hand began to move, which samples belong to which step.
#pragma once

#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "assessment/motion/path.h"
#include "assessment/trial.h"

namespace assessment {

// Thresholds below which the hand counts as still; part of the version of the metrics that use
// them.
inline constexpr double kMovingSpeed = 1.0;                              // mm/s
inline constexpr double kTurningSpeed = 5.0 * std::numbers::pi / 180.0;  // rad/s, 5 deg/s

// A range of intervals between samples: interval i lies between samples i and i + 1.
struct IntervalRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct Signals {
  const RecordedTrial* trial = nullptr;
  std::vector<double> times;           // s
  std::vector<Point> tip;              // mm, low-passed
  std::vector<double> tip_speed;       // mm/s, one per interval, of the low-passed path
  std::vector<double> turn;            // rad turned in each interval, signed
  std::optional<double> first_motion;  // s, when the handle first moved; absent: it never did
  double end = 0.0;  // s: the end of the last step, or of the recording while a step is undone

  // Steps that were begun: those done and the one under way.
  std::span<const TrialStep> begun() const;
  double end_of(const TrialStep& step) const { return step.done() ? step.ended : end; }
  // Intervals whose middle lies in the step. Steps follow each other, so each interval is in one.
  IntervalRange intervals(const TrialStep& step) const;
};

// Fails (absent) for a recording that no metric can be computed from: fewer than two samples, times
// that do not ascend, a value that is not finite.
std::optional<Signals> derive_signals(const RecordedTrial& trial);

// When the handle first moves faster than the thresholds, s.
std::optional<double> first_motion(std::span<const Sample> samples);

bool all_steps_done(const RecordedTrial& trial);

}  // namespace assessment
