#include "assessment/rule.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "assessment/verdict_sentence.h"
#include "assessment/words.h"

namespace assessment {
namespace {

constexpr Word<Comparison> kSigns[] = {
    {Comparison::less, "<"},       {Comparison::less_equal, "<="},    {Comparison::equal, "=="},
    {Comparison::not_equal, "!="}, {Comparison::greater_equal, ">="}, {Comparison::greater, ">"}};

constexpr Word<Outcome> kOutcomes[] = {{Outcome::passed, "passed"},
                                       {Outcome::not_passed, "not_passed"},
                                       {Outcome::invalid, "invalid"}};

Comparison opposite(Comparison comparison) {
  switch (comparison) {
    case Comparison::less:
      return Comparison::greater_equal;
    case Comparison::less_equal:
      return Comparison::greater;
    case Comparison::equal:
      return Comparison::not_equal;
    case Comparison::not_equal:
      return Comparison::equal;
    case Comparison::greater_equal:
      return Comparison::less;
    case Comparison::greater:
      return Comparison::less_equal;
  }
  return comparison;
}

// What the leaves are looked up in.
struct Evidence {
  const RecordedTrial& trial;
  std::span<const MetricValue> values;
};

std::optional<double> metric_value(const Evidence& evidence, const std::string& id) {
  for (const MetricValue& value : evidence.values) {
    if (value.id == id && std::isfinite(value.value)) return value.value;
  }
  return std::nullopt;
}

std::optional<double> error_count(const Evidence& evidence, const std::string& subject) {
  Severity severity;
  if (!parse(subject, severity)) return std::nullopt;
  return static_cast<double>(
      std::count_if(evidence.trial.events.begin(), evidence.trial.events.end(),
                    [severity](const Event& event) { return event.severity == severity; }));
}

bool goal_reached(const RecordedTrial& trial) {
  return trial.end_reason == EndReason::completed &&
         std::all_of(trial.steps.begin(), trial.steps.end(),
                     [](const TrialStep& step) { return step.done(); });
}

Criterion judge_leaf(const Rule& rule, bool negated, const Evidence& evidence) {
  Criterion criterion;
  criterion.comparison = rule.comparison;
  criterion.bound = rule.bound;
  criterion.benchmark = rule.benchmark;
  criterion.provisional = rule.provisional;
  switch (rule.kind) {
    case Rule::Kind::errors:
      criterion.subject = "errors." + rule.subject;
      criterion.value = error_count(evidence, rule.subject);
      break;
    case Rule::Kind::goal:
      criterion.subject = "goal." + rule.subject;
      criterion.comparison = Comparison::equal;
      criterion.bound = 1.0;
      if (rule.subject == "reached") criterion.value = goal_reached(evidence.trial) ? 1.0 : 0.0;
      break;
    default:
      criterion.subject = rule.subject;
      criterion.value = metric_value(evidence, rule.subject);
      break;
  }
  if (negated) criterion.comparison = opposite(criterion.comparison);
  criterion.met = criterion.value && holds(*criterion.value, criterion.comparison, criterion.bound);
  return criterion;
}

// Whether a part of the rule is met, and the criteria (by position) that made it so.
struct Finding {
  bool met = true;
  std::vector<std::size_t> because;
};

// `negated` is carried down to the leaves (De Morgan), so that each criterion reads as required.
Finding judge_node(const Rule& rule, bool negated, const Evidence& evidence,
                   std::vector<Criterion>& criteria) {
  const bool is_leaf = rule.kind == Rule::Kind::metric || rule.kind == Rule::Kind::errors ||
                       rule.kind == Rule::Kind::goal;
  if (is_leaf) {
    criteria.push_back(judge_leaf(rule, negated, evidence));
    return {criteria.back().met, {criteria.size() - 1}};
  }
  if (rule.kind == Rule::Kind::negate) negated = !negated;
  const bool needs_all = (rule.kind == Rule::Kind::any) == negated;
  Finding met{needs_all, {}}, unmet{needs_all, {}};
  for (const Rule& child : rule.children) {
    const Finding finding = judge_node(child, negated, evidence, criteria);
    Finding& side = finding.met ? met : unmet;
    side.because.insert(side.because.end(), finding.because.begin(), finding.because.end());
    const bool decides = finding.met != needs_all;
    if (decides) met.met = unmet.met = finding.met;
  }
  return met.met ? met : unmet;
}

// A critical error is never outweighed, and a limit that says "fail" means it.
bool vetoed(const RecordedTrial& trial) {
  return std::any_of(trial.events.begin(), trial.events.end(), [](const Event& event) {
    return event.severity == Severity::critical || event.severity == Severity::fail;
  });
}

}  // namespace

const char* sign(Comparison comparison) { return word_of<Comparison>(kSigns, comparison); }
bool parse(const std::string& text, Comparison& comparison) {
  return value_of<Comparison>(kSigns, text, comparison);
}
const char* word(Outcome outcome) { return word_of<Outcome>(kOutcomes, outcome); }
bool parse(const std::string& text, Outcome& outcome) {
  return value_of<Outcome>(kOutcomes, text, outcome);
}

bool holds(double value, Comparison comparison, double bound) {
  if (std::isnan(value) || std::isnan(bound)) return false;
  switch (comparison) {
    case Comparison::less:
      return value < bound;
    case Comparison::less_equal:
      return value <= bound;
    case Comparison::equal:
      return value == bound;
    case Comparison::not_equal:
      return value != bound;
    case Comparison::greater_equal:
      return value >= bound;
    case Comparison::greater:
      return value > bound;
  }
  return false;
}

Verdict judge(const Rule& rule, const RecordedTrial& trial, std::span<const MetricValue> values,
              std::span<const LimitBound> limits) {
  Verdict verdict;
  const Finding finding = judge_node(rule, false, {trial, values}, verdict.criteria);
  switch (trial.end_reason) {
    case EndReason::aborted:
    case EndReason::diverged:
      verdict.outcome = Outcome::invalid;
      break;
    case EndReason::timeout:
    case EndReason::limit:
      verdict.outcome = Outcome::not_passed;
      break;
    case EndReason::completed:
      verdict.outcome = finding.met && !vetoed(trial) ? Outcome::passed : Outcome::not_passed;
      break;
  }
  verdict.sentence = verdict_sentence(verdict, finding.because, trial, limits);
  return verdict;
}

}  // namespace assessment
