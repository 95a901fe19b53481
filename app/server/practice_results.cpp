#include "app/server/practice_results.h"

#include <utility>

#include "app/server/throttle.h"

namespace app {

void PracticeResults::keep(const std::string& practice_id, PracticeResult result, double now) {
  const std::lock_guard lock(mutex_);
  std::erase_if(kept_, [&](const auto& item) { return now - item.second.since > kKept; });
  kept_[practice_id] = {std::move(result), now};
  if (kept_.size() > kMostKept) kept_.erase(kept_.begin());
}

std::optional<PracticeResult> PracticeResults::find(const std::string& practice_id) {
  return find(practice_id, steady_seconds());
}

std::optional<PracticeResult> PracticeResults::find(const std::string& practice_id, double now) {
  const std::lock_guard lock(mutex_);
  const auto found = kept_.find(practice_id);
  if (found == kept_.end() || now - found->second.since > kKept) return std::nullopt;
  return found->second.result;
}

}  // namespace app
