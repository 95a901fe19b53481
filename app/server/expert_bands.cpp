#include "app/server/expert_bands.h"

#include <vector>

#include "assessment/metrics.h"
#include "assessment/statistics/descriptive.h"
#include "database/trial_summaries.h"

namespace app {
namespace {

constexpr std::chrono::seconds kKept{60};

}  // namespace

base::Result<ExpertBands> expert_bands(database::Store& store) {
  const auto means = database::expert_means(store);
  if (!means) return means.error();
  std::map<std::pair<std::string, std::string>, std::vector<double>> values;
  for (const database::ExpertMean& row : *means) {
    // a formula that has changed since gives other numbers
    const auto* metric = assessment::find_metric(row.metric);
    if (metric == nullptr || metric->version != row.version) continue;
    values[{row.exercise_id, row.metric}].push_back(row.mean);
  }
  ExpertBands bands;
  for (const auto& [what, of_people] : values) {
    if (of_people.size() < kFewestExperts) continue;
    bands[what] = {assessment::quantile(of_people, 0.25), assessment::median_of(of_people),
                   assessment::quantile(of_people, 0.75), static_cast<int>(of_people.size())};
  }
  return bands;
}

base::Result<std::shared_ptr<const ExpertBands>> ExpertBandCache::current(database::Store& store) {
  // held while they are worked out: who comes meanwhile waits rather than doing the same work
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (bands_ != nullptr && now - made_ < kKept) return bands_;
  auto bands = expert_bands(store);
  if (!bands) return bands.error();
  bands_ = std::make_shared<const ExpertBands>(*std::move(bands));
  made_ = now;
  return bands_;
}

}  // namespace app
