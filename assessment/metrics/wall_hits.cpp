#include <cmath>

#include "assessment/metrics/family.h"

namespace assessment {
namespace {

// Part of the metric's version. A hit begins when the force rises to kOn, ends when it falls to
// kOff, and begins at the earliest kApart after the last one began.
constexpr double kOn = 0.10;    // N
constexpr double kOff = 0.05;   // N
constexpr double kApart = 0.2;  // s

std::optional<double> wall_hits(const Signals& signals) {
  int hits = 0;
  bool touching = false;
  std::optional<double> last;
  for (const Sample& sample : signals.trial->samples) {
    const bool apart = !last || sample.time - *last >= kApart - 1e-9;
    if (!touching && sample.contact_force >= kOn && apart) {
      touching = true;
      last = sample.time;
      ++hits;
    } else if (touching && sample.contact_force <= kOff) {
      touching = false;
    }
  }
  return hits;
}

constexpr Metric kMetrics[] = {
    {{"wall_hits", 1, "", Direction::lower_is_better, "Wall hits",
      "How often the instrument hit the wall: the contact force rose to 0.10 N after having "
      "fallen to 0.05 N, at least 0.2 s after the hit before."},
     wall_hits}};

}  // namespace

std::span<const Metric> wall_hit_metrics() { return kMetrics; }

}  // namespace assessment
