#include "assessment/verdict_sentence.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <vector>

#include "assessment/number_text.h"

namespace assessment {
namespace {

// The name of a metric as it stands inside a sentence, and its unit.
struct Naming {
  std::string name;
  std::string_view unit;
  bool is_count = false;
};

Naming naming_of(const std::string& metric) {
  const MetricDefinition* definition = find_metric(metric);
  if (definition == nullptr) return {metric, "", false};
  std::string name(definition->title);
  name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
  // what has no unit is either a number of mishaps or a ratio that should be high
  const bool is_count =
      definition->unit.empty() && definition->direction == Direction::lower_is_better;
  return {name, definition->unit, is_count};
}

std::string with_unit(const std::string& number, std::string_view unit) {
  return unit.empty() ? number : number + " " + std::string(unit);
}

std::string joined(const std::vector<std::string>& parts, const char* separator) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : separator) + part;
  return text;
}

std::string target_words(const Criterion& criterion, std::string_view unit) {
  return std::string("the ") + (criterion.provisional ? "provisional " : "") + "target of " +
         with_unit(exact_text(criterion.bound), unit);
}

// "112.4 s", "path economy of 0.85", "7 wall hits". Seconds need no name.
std::string subject_words(const Criterion& criterion, const Naming& naming) {
  std::string value =
      with_unit(text_beside(*criterion.value, criterion.bound, naming.unit), naming.unit);
  if (criterion.subject == "time_s") return value;
  return naming.is_count ? value + " " + naming.name : naming.name + " of " + value;
}

std::string why_metric_fails(const Criterion& criterion) {
  const Naming naming = naming_of(criterion.subject);
  if (!criterion.value) return "this trial has no value for " + naming.name;
  const std::string subject = subject_words(criterion, naming);
  const std::string verb = naming.is_count && *criterion.value != 1.0 ? " are " : " is ";
  const std::string target = target_words(criterion, naming.unit);
  if (*criterion.value == criterion.bound)
    return subject + verb + "just " + target + ", which does not meet it";
  if (criterion.comparison == Comparison::equal) return subject + verb + "not " + target;
  const std::string distance =
      with_unit(distance_text(*criterion.value, criterion.bound, naming.unit), naming.unit);
  const char* side = *criterion.value > criterion.bound ? " over " : " under ";
  return subject + verb + distance + side + target;
}

std::string how_metric_passes(const Criterion& criterion) {
  const Naming naming = naming_of(criterion.subject);
  const std::string value =
      with_unit(text_beside(*criterion.value, criterion.bound, naming.unit), naming.unit);
  return (criterion.subject == "time_s" ? "" : naming.name + " ") + value + ", target " +
         with_unit(exact_text(criterion.bound), naming.unit) +
         (criterion.provisional ? " (provisional)" : "");
}

const char* error_words(Severity severity) {
  switch (severity) {
    case Severity::critical:
      return "critical error";
    case Severity::fail:
      return "failing error";
    case Severity::mark:
      return "marked error";
    case Severity::info:
      break;
  }
  return "event";
}

std::string counted(double count, const char* noun) {
  return (count == 0.0 ? "no" : exact_text(count)) + " " + noun + (count > 1.0 ? "s" : "");
}

// "peak contact force reached 2.31 N, above the limit of 2 N"
std::string breach_words(const Event& event, std::span<const LimitBound> limits) {
  if (event.code != "limit_breached") {
    std::string words = event.code;
    std::replace(words.begin(), words.end(), '_', ' ');
    return words + " at " + rounded_text(event.time, "s") + " s";
  }
  const Naming naming = naming_of(event.detail);
  const auto limit = std::find_if(limits.begin(), limits.end(), [&](const LimitBound& candidate) {
    return candidate.metric == event.detail &&
           !holds(event.value, candidate.comparison, candidate.bound);
  });
  if (limit == limits.end()) {
    return naming.name + " reached " +
           with_unit(rounded_text(event.value, naming.unit), naming.unit) +
           ", beyond the limit of the exercise";
  }
  const double bound = limit->bound;
  const char* side = event.value > bound   ? ", above the limit of "
                     : event.value < bound ? ", below the limit of "
                                           : ", which is at the limit of ";
  return naming.name + " reached " +
         with_unit(text_beside(event.value, bound, naming.unit), naming.unit) + side +
         with_unit(exact_text(bound), naming.unit);
}

// The first error of a severity, and how many more there are. Empty when there is none.
std::string errors_of(Severity severity, const RecordedTrial& trial,
                      std::span<const LimitBound> limits) {
  std::vector<const Event*> errors;
  for (const Event& event : trial.events) {
    // the end of the trial by its time limit is said in words of its own
    if (event.severity == severity && event.code != "timeout") errors.push_back(&event);
  }
  if (errors.empty()) return {};
  std::string text = breach_words(*errors.front(), limits);
  text += severity == Severity::fail ? ", which fails the trial"
                                     : std::string(": a ") + error_words(severity);
  if (errors.size() > 1) text += ", and " + std::to_string(errors.size() - 1) + " more";
  return text;
}

std::string why_errors_fail(const Criterion& criterion, const RecordedTrial& trial,
                            std::span<const LimitBound> limits) {
  Severity severity;
  if (!criterion.value || !parse(criterion.subject.substr(7), severity)) {
    return "its errors could not be counted";
  }
  std::string errors = errors_of(severity, trial, limits);
  if (criterion.bound == 0.0 && !errors.empty()) return errors;
  return counted(*criterion.value, error_words(severity)) + " where " +
         std::string(sign(criterion.comparison)) + " " + exact_text(criterion.bound) +
         " is asked for";
}

bool is_errors(const Criterion& criterion) { return criterion.subject.rfind("errors.", 0) == 0; }
bool is_goal(const Criterion& criterion) { return criterion.subject.rfind("goal.", 0) == 0; }

std::string why_fails(const Criterion& criterion, const RecordedTrial& trial,
                      std::span<const LimitBound> limits) {
  if (is_errors(criterion)) return why_errors_fail(criterion, trial, limits);
  if (is_goal(criterion)) return "the goal was not reached";
  return why_metric_fails(criterion);
}

std::string how_passes(const Criterion& criterion) {
  if (is_goal(criterion)) return "goal reached";
  if (!is_errors(criterion)) return how_metric_passes(criterion);
  Severity severity = Severity::critical;
  parse(criterion.subject.substr(7), severity);
  return counted(*criterion.value, error_words(severity));
}

// "with 1 of 3 steps done", "in step 2 of 3 (retract)"
std::string progress_words(const RecordedTrial& trial) {
  const auto undone = std::find_if(trial.steps.begin(), trial.steps.end(),
                                   [](const TrialStep& step) { return !step.done(); });
  if (undone == trial.steps.end()) return {};
  return "in step " + std::to_string(undone - trial.steps.begin() + 1) + " of " +
         std::to_string(trial.steps.size()) + " (" + undone->id + ")";
}

// The limit that stopped the trial: the last one broken.
std::string limit_words(const RecordedTrial& trial, std::span<const LimitBound> limits) {
  const auto last = std::find_if(trial.events.rbegin(), trial.events.rend(),
                                 [](const Event& event) { return event.code == "limit_breached"; });
  return last == trial.events.rend() ? "a limit of the exercise was broken"
                                     : breach_words(*last, limits);
}

std::string end_words(const RecordedTrial& trial, std::span<const LimitBound> limits) {
  const std::string time = rounded_text(trial.end_time, "s") + " s";
  const std::string progress = progress_words(trial);
  const std::string where = progress.empty() ? "" : ", " + progress;
  switch (trial.end_reason) {
    case EndReason::aborted:
      return "the trial was ended early, at " + time + where;
    case EndReason::diverged:
      return "the simulation failed at " + time + " and was stopped; this is not your fault";
    case EndReason::timeout:
      return "the time limit of the exercise was reached at " + time + where;
    case EndReason::limit:
      return limit_words(trial, limits) + ", which ended the trial at " + time + where;
    case EndReason::completed:
      break;
  }
  return {};
}

std::vector<std::string> reasons(const Verdict& verdict, std::span<const std::size_t> because,
                                 const RecordedTrial& trial, std::span<const LimitBound> limits) {
  std::vector<std::string> parts;
  const auto add = [&parts](const std::string& part) {
    // an error that the rule names too is said once
    if (!part.empty() && std::find(parts.begin(), parts.end(), part) == parts.end()) {
      parts.push_back(part);
    }
  };
  if (trial.end_reason != EndReason::completed) add(end_words(trial, limits));
  add(errors_of(Severity::critical, trial, limits));
  if (trial.end_reason != EndReason::limit) add(errors_of(Severity::fail, trial, limits));
  if (trial.end_reason != EndReason::completed) return parts;
  for (const std::size_t position : because) {
    const Criterion& criterion = verdict.criteria[position];
    if (!criterion.met) add(why_fails(criterion, trial, limits));
  }
  return parts;
}

}  // namespace

std::string verdict_sentence(const Verdict& verdict, std::span<const std::size_t> because,
                             const RecordedTrial& trial, std::span<const LimitBound> limits) {
  if (verdict.outcome == Outcome::invalid) return "Not counted: " + end_words(trial, limits) + ".";
  if (verdict.outcome == Outcome::not_passed) {
    const std::vector<std::string> parts = reasons(verdict, because, trial, limits);
    if (parts.empty()) return "Not passed: the pass rule of this exercise admits no trial.";
    return "Not passed: " + joined(parts, "; ") + ".";
  }
  std::vector<std::string> parts;
  for (const std::size_t position : because)
    parts.push_back(how_passes(verdict.criteria[position]));
  return parts.empty() ? "Passed." : "Passed: " + joined(parts, ", ") + ".";
}

}  // namespace assessment
