// Checks of the mechanics against what is known without this program: closed forms, the elastica,
// requirements. Anybody can run them with their own parameters.
//
//     for (const CaseDefinition& definition : validation::cases()) ...
//     auto result = validation::run("cantilever", {{"load", 0.25}});
//
// What was simulated, what is expected and how they compare are kept apart: nothing under
// `simulated` is taken from theory.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/result.h"

namespace sim::validation {

struct ParameterDefinition {
  std::string id;
  std::string meaning;
  std::string unit;  // "1" for a pure number
  double default_value = 0.0;
  double minimum = 0.0;
  double maximum = 0.0;
  bool whole = false;  // whole numbers only
};

struct CaseDefinition {
  std::string id;
  std::string title;
  std::string setup;    // what is simulated, in words
  std::string formula;  // what it is compared with
  std::string source;
  std::vector<ParameterDefinition> parameters;
};

struct Quantity {
  std::string name;
  double value = 0.0;
  std::string unit;
};

struct Expectation {
  std::string name;
  double value = 0.0;
  std::string unit;
  std::string source;
};

// `deviation` and `bound` in `unit`; passed when |deviation| <= bound.
struct Check {
  std::string name;
  double deviation = 0.0;
  double bound = 0.0;
  std::string unit;
  bool passed = false;
};

struct CaseResult {
  std::string id;
  std::vector<Quantity> parameters;  // all of them, as used
  std::vector<Quantity> simulated;
  std::vector<Expectation> expected;
  std::vector<Check> checks;

  bool passed() const {
    for (const Check& check : checks) {
      if (!check.passed) return false;
    }
    return !checks.empty();
  }
};

// Called now and then with the share done, 0 to 1.
using Progress = std::function<void(double)>;

std::span<const CaseDefinition> cases();

// Runs one case; parameters not given take their defaults. Errors: not_found for an unknown case,
// invalid_input for an unknown parameter, one out of its range, or a combination to which the
// comparison does not apply, unavailable when the simulation itself failed.
base::Result<CaseResult> run(std::string_view id,
                             const std::map<std::string, double>& parameters = {},
                             const Progress& progress = {});

}  // namespace sim::validation
