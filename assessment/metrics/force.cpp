// Contact force: the largest norm of the vector sum of wall reactions over any 6 mm of the
// instrument, as the recording holds it.
#include <algorithm>
#include <cmath>

#include "assessment/metrics/breach.h"
#include "assessment/metrics/family.h"
#include "assessment/statistics/descriptive.h"

namespace assessment {
namespace {

std::vector<double> forces(const Signals& signals) {
  std::vector<double> result;
  result.reserve(signals.trial->samples.size());
  for (const Sample& sample : signals.trial->samples) result.push_back(sample.contact_force);
  return result;
}

// Of every step, not only of the samples: each sample holds the peak since the one before.
std::optional<double> largest(const Signals& signals) {
  double peak = value_at_breach(*signals.trial, "force_max_n");
  for (const Sample& sample : signals.trial->samples) {
    peak = std::max({peak, sample.contact_force, sample.contact_force_peak});
  }
  return peak;
}

std::optional<double> percentile_95(const Signals& signals) {
  return quantile(forces(signals), 0.95);
}

std::optional<double> mean_in_contact(const Signals& signals) {
  std::vector<double> touching = forces(signals);
  std::erase_if(touching, [](double force) { return !(force > 0.0); });
  return touching.empty() ? std::nullopt : std::optional(mean_of(touching));
}

std::optional<double> root_mean_square(const Signals& signals) {
  const std::vector<double> all = forces(signals);
  return std::sqrt(sum_of_squares_about(0.0, all) / static_cast<double>(all.size()));
}

std::optional<double> impulse(const Signals& signals) {
  const auto& samples = signals.trial->samples;
  double sum = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    sum += 0.5 * (samples[i].contact_force + samples[i - 1].contact_force) *
           (samples[i].time - samples[i - 1].time);
  }
  return sum;
}

std::optional<double> fastest_rise(const Signals& signals) {
  const auto& samples = signals.trial->samples;
  double rate = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    rate = std::max(rate, (samples[i].contact_force - samples[i - 1].contact_force) /
                              (samples[i].time - samples[i - 1].time));
  }
  return rate;
}

constexpr Metric kMetrics[] = {
    {{"force_max_n", 1, "N", Direction::lower_is_better, "Peak contact force",
      "The largest force between the instrument and the wall (over any 6 mm of the instrument)."},
     largest},
    {{"force_p95_n", 1, "N", Direction::lower_is_better, "Contact force, 95th percentile",
      "The contact force that was exceeded for 5 percent of the time."},
     percentile_95},
    {{"force_mean_contact_n", 1, "N", Direction::lower_is_better, "Mean contact force",
      "The mean contact force while the instrument touched the wall."},
     mean_in_contact},
    {{"force_rms_n", 1, "N", Direction::lower_is_better, "Contact force, root mean square",
      "The root mean square of the contact force over the whole trial, in which high forces weigh "
      "more."},
     root_mean_square},
    {{"contact_impulse_n_s", 1, "N s", Direction::lower_is_better, "Contact impulse",
      "Contact force summed over time: how hard and how long the wall was touched."},
     impulse},
    {{"force_rate_max_n_s", 1, "N/s", Direction::lower_is_better, "Fastest rise of force",
      "How abruptly the contact force rose at most."},
     fastest_rise}};

}  // namespace

std::span<const Metric> force_metrics() { return kMetrics; }

}  // namespace assessment
