// Reads `pass:` of an exercise into the rule that judges its trials, benchmarks resolved.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "assessment/rule.h"
#include "curricula/fields.h"

namespace curricula {

struct RuleContext {
  std::span<const Benchmark> benchmarks;
  std::span<const std::string> recorded;  // metric ids of the exercise
  bool truncated = false;                 // a benchmark may stand behind a syntax error
};

assessment::Rule read_rule(const YamlNode& node, const RuleContext& context, Problems& problems);

}  // namespace curricula
