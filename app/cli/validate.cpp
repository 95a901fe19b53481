// cathedra validate list | run: the mechanics against closed forms, with anybody's parameters.
#include <charconv>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "sim/validation/validation_case.h"

namespace app::cli {
namespace {

using nlohmann::ordered_json;
namespace validation = sim::validation;

struct Options {
  std::string id;
  std::vector<std::string> settings;
};

ordered_json definition_json(const validation::CaseDefinition& definition) {
  ordered_json parameters = ordered_json::array();
  for (const validation::ParameterDefinition& parameter : definition.parameters) {
    parameters.push_back({{"id", parameter.id},
                          {"meaning", parameter.meaning},
                          {"unit", parameter.unit},
                          {"default", parameter.default_value},
                          {"minimum", parameter.minimum},
                          {"maximum", parameter.maximum}});
  }
  return {{"case", definition.id},       {"title", definition.title},
          {"setup", definition.setup},   {"formula", definition.formula},
          {"source", definition.source}, {"parameters", parameters}};
}

void list(Output& output) {
  ordered_json rows = ordered_json::array();
  for (const validation::CaseDefinition& definition : validation::cases()) {
    rows.push_back(definition_json(definition));
  }
  if (output.json) return output.print(rows);
  for (const validation::CaseDefinition& definition : validation::cases()) {
    std::cout << definition.id << ": " << definition.title << '\n';
    for (const validation::ParameterDefinition& parameter : definition.parameters) {
      std::cout << "    --set " << std::left << std::setw(20)
                << parameter.id + "=" + ordered_json(parameter.default_value).dump()
                << parameter.meaning << " [" << parameter.unit << "], " << parameter.minimum
                << " to " << parameter.maximum << '\n';
    }
  }
}

// "key=value" -> the map; an error names the setting.
base::Result<std::map<std::string, double>> parse_settings(
    const std::vector<std::string>& settings) {
  std::map<std::string, double> values;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    const std::string number = equals == std::string::npos ? "" : setting.substr(equals + 1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (number.empty() || error != std::errc{} || end != number.data() + number.size()) {
      return base::Error{
          base::ErrorCode::invalid_input,
          "cannot read \"" + setting + "\"; write --set name=number, e.g. --set load=0.5"};
    }
    values[setting.substr(0, equals)] = value;
  }
  return values;
}

template <typename Named>
ordered_json values_json(const std::vector<Named>& quantities) {
  ordered_json object = ordered_json::object();
  for (const Named& quantity : quantities) {
    object[quantity.name] = {{"value", quantity.value}, {"unit", quantity.unit}};
  }
  return object;
}

ordered_json result_json(const validation::CaseResult& result) {
  ordered_json expected = ordered_json::object();
  for (const validation::Expectation& expectation : result.expected) {
    expected[expectation.name] = {
        {"value", expectation.value}, {"unit", expectation.unit}, {"source", expectation.source}};
  }
  ordered_json checks = ordered_json::array();
  for (const validation::Check& check : result.checks) {
    checks.push_back({{"name", check.name},
                      {"deviation", check.deviation},
                      {"bound", check.bound},
                      {"unit", check.unit},
                      {"passed", check.passed}});
  }
  return {{"case", result.id},
          {"passed", result.passed()},
          {"parameters", values_json(result.parameters)},
          {"simulated", values_json(result.simulated)},
          {"expected", expected},
          {"checks", checks}};
}

void run(const Options& options, Output& output) {
  const auto values = parse_settings(options.settings);
  if (!values) return output.fail(values.error());
  const auto result = [&] {
    ProgressBar bar(options.id);
    return validation::run(options.id, *values, [&](double fraction) { bar.set(fraction); });
  }();
  if (!result) {
    const bool call = result.error().code != base::ErrorCode::unavailable;
    return output.fail(result.error().message, call ? kWrongCall : kFailed);
  }
  output.exit_code = result->passed() ? kWorked : kFailed;
  if (output.json) return output.print(result_json(*result));
  std::cout << result->id << (result->passed() ? ": passed\n" : ": NOT passed\n");
  for (const validation::Quantity& quantity : result->simulated) {
    std::cout << "  simulated  " << std::left << std::setw(34) << quantity.name
              << std::setprecision(7) << quantity.value << ' ' << quantity.unit << '\n';
  }
  for (const validation::Expectation& expectation : result->expected) {
    std::cout << "  expected   " << std::left << std::setw(34) << expectation.name
              << std::setprecision(7) << expectation.value << ' ' << expectation.unit << "  ("
              << expectation.source << ")\n";
  }
  for (const validation::Check& check : result->checks) {
    std::cout << (check.passed ? "  good       " : "  BAD        ") << std::left << std::setw(34)
              << check.name << std::setprecision(3) << check.deviation << " of at most "
              << check.bound << ' ' << check.unit << '\n';
  }
}

}  // namespace

void add_validate(CLI::App& app, Output& output) {
  CLI::App* validate = app.add_subcommand("validate", "The mechanics against closed forms");
  validate->require_subcommand(1);
  validate->footer("Example: cathedra validate run cantilever --set load=0.5 --set elements=50");
  CLI::App* list_command = validate->add_subcommand("list", "All cases with their parameters");
  list_command->footer("Example: cathedra validate list --json");
  add_json_flag(*list_command, output);
  list_command->callback([&output] { list(output); });
  auto options = std::make_shared<Options>();  // shared: kept alive by the callback
  CLI::App* run_command = validate->add_subcommand(
      "run", "Simulate one case and compare; exit code 1 when a bound is not held");
  run_command->footer("Example: cathedra validate run capstan --set mu=0.2 --json");
  run_command->add_option("case", options->id, "Id of the case")->required();
  run_command->add_option("--set", options->settings, "name=value, in the unit the list shows")
      ->take_all();
  add_json_flag(*run_command, output);
  run_command->callback([options, &output] { run(*options, output); });
}

}  // namespace app::cli
