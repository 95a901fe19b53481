#include "app/session/record_comparison.h"

#include <algorithm>
#include <vector>

namespace app {
namespace {

using assessment::Event;
using assessment::TrialStep;

// Pauses happened on the wall clock; the replay has none.
std::vector<Event> without_pauses(std::vector<Event> events) {
  std::erase_if(events, [](const Event& e) { return e.code == "paused" || e.code == "resumed"; });
  return events;
}

bool same_event(const Event& a, const Event& b) {
  return a.time == b.time && a.code == b.code && a.severity == b.severity && a.detail == b.detail &&
         a.value == b.value;
}

bool same_step(const TrialStep& a, const TrialStep& b) {
  return a.id == b.id && a.kind == b.kind && a.target == b.target && a.tolerance == b.tolerance &&
         a.started == b.started && a.ended == b.ended && a.residual == b.residual;
}

bool same_criterion(const assessment::Criterion& a, const assessment::Criterion& b) {
  return a.subject == b.subject && a.comparison == b.comparison && a.bound == b.bound &&
         a.value == b.value && a.met == b.met;
}

// The first metric whose stored value is not the replayed one; empty when all agree.
std::string differing_metric(const std::vector<assessment::MetricValue>& stored,
                             const std::vector<assessment::MetricValue>& replayed) {
  for (const assessment::MetricValue& metric : replayed) {
    const bool same = std::any_of(stored.begin(), stored.end(), [&](const auto& other) {
      return other.id == metric.id && other.value == metric.value;
    });
    if (!same) return "the metric " + metric.id;
  }
  return stored.size() == replayed.size() ? "" : "the list of metrics";
}

bool same_verdict(const assessment::Verdict& a, const assessment::Verdict& b) {
  return a.outcome == b.outcome && a.sentence == b.sentence &&
         std::equal(a.criteria.begin(), a.criteria.end(), b.criteria.begin(), b.criteria.end(),
                    same_criterion);
}

}  // namespace

base::Result<std::string> difference_from_record(database::Store& store,
                                                 const database::StoredTrial& stored,
                                                 const curricula::Exercise& exercise,
                                                 const TrialRun& replayed) {
  const assessment::RecordedTrial trial = replayed.recorded_trial();
  if (stored.end_reason != trial.end_reason) return std::string("the reason of the end");
  if (stored.end_time_s != trial.end_time) return std::string("the time of the end");
  if (stored.state_hash != replayed.state_hash()) return std::string("the final state");
  if (stored.input_sha256 != replayed.input_sha256()) return std::string("the hash of the inputs");

  const auto steps = database::trial_steps(store, stored.head.id);
  if (!steps) return steps.error();
  if (!std::equal(steps->begin(), steps->end(), trial.steps.begin(), trial.steps.end(),
                  same_step)) {
    return std::string("the steps");
  }
  auto events = database::trial_events(store, stored.head.id);
  if (!events) return events.error();
  const std::vector<Event> there = without_pauses(*std::move(events));
  const std::vector<Event> here = without_pauses(trial.events);
  if (!std::equal(there.begin(), there.end(), here.begin(), here.end(), same_event)) {
    return std::string("the events");
  }

  const Judgement judgement = judge(exercise, trial);
  const std::string metric = differing_metric(stored.metrics, judgement.metrics);
  if (!metric.empty()) return metric;
  const auto verdict = database::trial_verdict(store, stored.head.id);
  if (!verdict) return verdict.error();
  return same_verdict(*verdict, judgement.verdict) ? std::string() : std::string("the verdict");
}

}  // namespace app
