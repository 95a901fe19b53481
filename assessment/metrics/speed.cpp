#include <algorithm>
#include <cmath>

#include "assessment/metrics/family.h"
#include "assessment/motion/peaks.h"

namespace assessment {
namespace {

constexpr double kShortestIdle = 0.5;  // s

std::optional<double> mean_speed(const Signals& signals) {
  if (!signals.first_motion || signals.end <= *signals.first_motion) return std::nullopt;
  return path_length(signals.tip) / (signals.end - *signals.first_motion);
}

std::optional<double> peak_speed(const Signals& signals) {
  return *std::max_element(signals.tip_speed.begin(), signals.tip_speed.end());
}

std::optional<double> idle_time(const Signals& signals) {
  if (!signals.first_motion) return std::nullopt;
  std::vector<bool> idle(signals.tip_speed.size());
  for (std::size_t i = 0; i < idle.size(); ++i) {
    const double duration = signals.times[i + 1] - signals.times[i];
    const bool within = signals.times[i] >= *signals.first_motion - 1e-9 &&
                        signals.times[i + 1] <= signals.end + 1e-9;
    idle[i] = within && signals.tip_speed[i] < kMovingSpeed &&
              std::abs(signals.turn[i]) < kTurningSpeed * duration;
  }
  return time_in_runs(idle, signals.times, kShortestIdle);
}

std::optional<double> submovements(const Signals& signals) {
  return count_submovements(signals.tip_speed, kSampleRate);
}

constexpr Metric kMetrics[] = {
    {{"speed_mean_mm_s", 1, "mm/s", Direction::higher_is_better, "Mean speed",
      "Path length of the tip divided by the time from the first movement to the end."},
     mean_speed},
    {{"speed_max_mm_s", 1, "mm/s", Direction::lower_is_better, "Peak speed",
      "The fastest the tip moved."},
     peak_speed},
    {{"idle_s", 1, "s", Direction::lower_is_better, "Idle time",
      "Time with the tip below 1 mm/s and the rotation below 5 degrees per second, counted where "
      "it lasts half a second or longer."},
     idle_time},
    {{"submovements", 1, "", Direction::lower_is_better, "Submovements",
      "Number of peaks of the tip's speed: how often the movement was started anew."},
     submovements}};

}  // namespace

std::span<const Metric> speed_metrics() { return kMetrics; }

}  // namespace assessment
