#include "sim/validation/validation_case.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>

#include "sim/validation/case_run.h"

namespace sim::validation {
namespace {

using Run = base::Status (*)(CaseRun&);

struct Case {
  CaseDefinition (*define)();
  Run run;
};

constexpr std::array kCases = {Case{cantilever_definition, run_cantilever},
                               Case{elastica_definition, run_elastica},
                               Case{buckling_definition, run_buckling},
                               Case{twist_definition, run_twist},
                               Case{capstan_definition, run_capstan},
                               Case{pre_curved_tip_definition, run_pre_curved_tip},
                               Case{whip_definition, run_whip},
                               Case{stiction_definition, run_stiction},
                               Case{feed_ripple_definition, run_feed_ripple},
                               Case{handle_force_definition, run_handle_force}};

const std::array<CaseDefinition, kCases.size()>& definitions() {
  static const auto all = [] {
    std::array<CaseDefinition, kCases.size()> list;
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = kCases[i].define();
    return list;
  }();
  return all;
}

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

template <typename Items>
std::string list_of_ids(const Items& items) {
  std::string text;
  for (const auto& item : items) text += (text.empty() ? "" : ", ") + item.id;
  return text;
}

base::Error invalid(const std::string& message) {
  return {base::ErrorCode::invalid_input, message};
}

base::Result<std::map<std::string, double>> complete(const CaseDefinition& definition,
                                                     const std::map<std::string, double>& given) {
  for (const auto& [id, value] : given) {
    const bool known = std::any_of(definition.parameters.begin(), definition.parameters.end(),
                                   [&id = id](const auto& p) { return p.id == id; });
    if (!known) {
      return invalid("The case " + definition.id + " has no parameter '" + id +
                     "'; it has: " + list_of_ids(definition.parameters) + ".");
    }
  }
  std::map<std::string, double> values;
  for (const ParameterDefinition& parameter : definition.parameters) {
    const auto found = given.find(parameter.id);
    const double value = found == given.end() ? parameter.default_value : found->second;
    const bool inside = value >= parameter.minimum && value <= parameter.maximum;
    if (!inside || (parameter.whole && value != std::round(value))) {
      const std::string unit = parameter.unit == "1" ? "" : " " + parameter.unit;
      return invalid("The parameter '" + parameter.id + "' must be a " +
                     (parameter.whole ? "whole number" : "number") + " from " +
                     number(parameter.minimum) + " to " + number(parameter.maximum) + unit +
                     ", not " + number(value) + ".");
    }
    values[parameter.id] = value;
  }
  return values;
}

}  // namespace

std::span<const CaseDefinition> cases() { return definitions(); }

base::Result<CaseResult> run(std::string_view id, const std::map<std::string, double>& parameters,
                             const Progress& progress) {
  const auto all = cases();
  const auto found =
      std::find_if(all.begin(), all.end(), [id](const auto& item) { return item.id == id; });
  if (found == all.end()) {
    return base::Error{base::ErrorCode::not_found, "There is no validation case '" +
                                                       std::string(id) +
                                                       "'; there are: " + list_of_ids(all) + "."};
  }
  auto values = complete(*found, parameters);
  if (!values) return values.error();

  CaseRun case_run(*values, progress);
  const base::Status done = kCases[static_cast<std::size_t>(found - all.begin())].run(case_run);
  if (!done) return done.error();
  CaseResult result = case_run.take_result();
  result.id = found->id;
  for (const ParameterDefinition& parameter : found->parameters) {
    result.parameters.push_back({parameter.id, values->at(parameter.id), parameter.unit});
  }
  return result;
}

}  // namespace sim::validation
