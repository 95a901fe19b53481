// The drawings of one trial's debrief.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/trial.h"
#include "reports/chart.h"

namespace reports {

// How long one step took: a bar per step; of a repeat, one bar per round.
struct StepDuration {
  std::string title;  // "Feed to 350 mm"
  double seconds = 0.0;
};
Chart step_time_chart(const std::vector<StepDuration>& steps);

// Contact force over simulated time with the steps above it, the limit as a line with its word,
// and the hardest wall hits lettered A, B, C. Thinned to what a screen can show, peaks kept.
Chart contact_force_chart(const assessment::RecordedTrial& trial, std::optional<double> limit_n);

}  // namespace reports
