// The experts' middle half of each metric of each exercise, to lie behind somebody's own curve.
//
// Every expert counts once, by the mean of his or her trials. Only live people and their live
// trials: published and simulated ones are never among them. Below five experts there is no band,
// which would tell one person's times.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "database/store.h"
#include "sim/base/result.h"

namespace app {

inline constexpr int kFewestExperts = 5;

struct ExpertBand {
  double low = 0.0, median = 0.0, high = 0.0;  // quartiles, in the unit of the metric
  int experts = 0;
};

// By exercise and metric.
using ExpertBands = std::map<std::pair<std::string, std::string>, ExpertBand>;

base::Result<ExpertBands> expert_bands(database::Store& store);

// Worked out once and kept for a minute: a page of progress does not read every expert's trials.
// May be used from several threads.
class ExpertBandCache {
 public:
  base::Result<std::shared_ptr<const ExpertBands>> current(database::Store& store);

 private:
  std::mutex mutex_;
  std::shared_ptr<const ExpertBands> bands_;  // shared: with requests that still draw them
  std::chrono::steady_clock::time_point made_;
};

}  // namespace app
