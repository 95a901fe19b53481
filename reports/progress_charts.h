// How one person's trials of an exercise went, one after the other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/metrics.h"
#include "reports/chart.h"

namespace reports {

struct TrialPoint {
  int ordinal = 0;
  double value = 0.0;
  bool passed = false;
  bool counted = true;  // voided and interrupted trials are drawn hollow
};

struct ProgressChart {
  std::string id;     // "linear-time"
  std::string title;  // "Time per trial"
  std::string unit;   // "s"
  std::string who;    // "You", or a name
  std::vector<TrialPoint> points;
  std::optional<double> target;  // a dashed line with its word
  bool target_provisional = false;
  std::optional<double> expert_low, expert_median, expert_high;  // band: the experts' middle half
  assessment::Direction direction = assessment::Direction::lower_is_better;
  int unfinished = 0;    // trials that were not completed, and so have no point
  int last_ordinal = 0;  // where the axis ends; 0: at the last point
};

// Works from one point on; with none it says so in the drawing.
Chart progress_chart(const ProgressChart& chart);
// The same in 220 x 120, to stand beside its like: two ticks, the last value, the words "target"
// and "experts".
Chart small_progress_chart(const ProgressChart& chart);

// "Linear: last three trials 98, 91, 79 s; target 90 s (provisional); 20 % faster than your first;
// not yet proficient (1 of 2 in a row)". Of the trials that count; without one it says why. `you`
// chooses between "your first" and "the first".
std::string progress_headline(const std::string& exercise_title, const ProgressChart& chart,
                              const std::string& proficiency, bool you);

}  // namespace reports
