// The pass rule of an exercise and the judgement of one trial by it.
//
//     pass: {all: [{metric: time_s, op: "<=", benchmark: linear_time},
//                  {errors: critical, op: "==", value: 0}]}
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/metrics.h"
#include "assessment/trial.h"

namespace assessment {

enum class Comparison { less, less_equal, equal, not_equal, greater_equal, greater };
const char* sign(Comparison comparison);  // "<=", ...
bool parse(const std::string& text, Comparison& comparison);
bool holds(double value, Comparison comparison, double bound);

// A leaf compares one quantity with a bound; a node combines its children.
struct Rule {
  enum class Kind { metric, errors, goal, all, any, negate };
  Kind kind = Kind::all;
  std::string subject;  // metric id; severity of the errors counted; goal ("reached")
  Comparison comparison = Comparison::less_equal;
  double bound = 0.0;          // in the metric's unit, or a count
  std::string benchmark;       // id of the benchmark the bound came from, or empty
  bool provisional = false;    // the benchmark is provisional
  std::vector<Rule> children;  // all, any, negate
};

// One leaf, judged.
struct Criterion {
  std::string subject;  // metric id, "errors.critical", "goal.reached"
  Comparison comparison = Comparison::less_equal;
  double bound = 0.0;
  std::optional<double> value;  // absent: the trial has no such value, so it is not met
  bool met = false;
  std::string benchmark;
  bool provisional = false;
};

enum class Outcome { passed, not_passed, invalid };  // invalid: aborted or diverged
const char* word(Outcome outcome);
bool parse(const std::string& text, Outcome& outcome);

struct Verdict {
  Outcome outcome = Outcome::invalid;
  std::vector<Criterion> criteria;  // every leaf, in the rule's order
  std::string sentence;             // one plain sentence: passed, or why not
};

// A limit of the exercise, for the sentence: the recording notes that one was broken and the value,
// not where it lay.
struct LimitBound {
  std::string metric;
  Comparison comparison = Comparison::less_equal;
  double bound = 0.0;  // in the metric's unit
};

// Judges a trial. A trial that did not complete never passes, and neither does one with a critical
// error or a broken limit whose consequence is to fail, whatever the rule: the sentence names the
// reason. A metric that the trial does not have is not met, and neither is its negation.
Verdict judge(const Rule& rule, const RecordedTrial& trial, std::span<const MetricValue> values,
              std::span<const LimitBound> limits = {});

}  // namespace assessment
