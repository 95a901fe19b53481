#include "assessment/metrics/breach.h"

#include <algorithm>
#include <cmath>

namespace assessment {

double value_at_breach(const RecordedTrial& trial, std::string_view metric) {
  double largest = 0.0;
  for (const Event& event : trial.events) {
    if (event.code == "limit_breached" && event.detail == metric && std::isfinite(event.value)) {
      largest = std::max(largest, event.value);
    }
  }
  return largest;
}

}  // namespace assessment
