#include "curricula/read_benchmarks.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "assessment/metrics.h"
#include "curricula/nearest.h"

namespace curricula {
namespace {

constexpr double kLargest = 1e9;  // of a pass mark, in whatever unit

// Metrics of the format that need what this version does not simulate yet.
constexpr std::array<std::string_view, 12> kLaterMetrics = {
    "perforations", "wrong_vessel", "wrong_vessel_s", "buckling_events",
    "buckling_s",   "fluoro_s",     "dap_gy_cm2",     "contrast_ml",
    "injections",   "composite",    "ldlj_stroke",    "submovements"};

const std::vector<std::string> kRules = {"fixed", "mean_plus_k_sd", "percentile",
                                         "contrasting_groups"};
const std::vector<std::string> kLevels = {"novice", "intermediate", "expert"};

void read_rule_kind(const YamlNode& node, Benchmark& benchmark, Problems& problems) {
  Fields rule(node, "the rule of a benchmark", problems);
  const auto kind = rule.need_choice("kind", kRules);
  benchmark.rule = kind ? kRules[*kind] : "";
  benchmark.provisional = rule.boolean("provisional").value_or(false);
  if (!kind) return;  // its other keys depend on the kind
  if (benchmark.rule == "mean_plus_k_sd") {
    rule.need_number("k", {-10.0, 10.0});
    rule.need_choice("over", {"participant_means"});
    rule.need_choice("group", kLevels);
  } else if (benchmark.rule == "percentile") {
    rule.need_number("percentile", {0.0, 100.0});
    rule.need_choice("over", {"participant_means"});
    rule.need_choice("group", kLevels);
  } else if (benchmark.rule == "contrasting_groups") {
    rule.need_choice("below", kLevels);
    rule.need_choice("above", kLevels);
  }
  rule.finish();
}

void read_source(const YamlNode& node, Benchmark& benchmark, Problems& problems) {
  Fields source(node, "the source of a benchmark", problems);
  benchmark.cohort = source.need_word("cohort");
  benchmark.apparatus = source.need_word("apparatus");
  benchmark.min_participants =
      static_cast<int>(source.integer("min_participants", 5, 10000).value_or(5));
  source.finish();
}

Benchmark read_benchmark(const YamlEntry& entry, Problems& problems) {
  Benchmark benchmark;
  benchmark.id = entry.key.text;
  if (!is_id(benchmark.id)) {
    problems.error(entry.key, "'" + benchmark.id +
                                  "' cannot be an id: use small letters, digits, "
                                  "'-' and '_', beginning with a letter");
  }
  Fields fields(entry.value, "a benchmark", problems);
  benchmark.metric = fields.need_word("metric");
  if (!benchmark.metric.empty()) check_metric(benchmark.metric, *fields.find("metric"), problems);
  if (const YamlNode* rule = fields.need("rule")) read_rule_kind(*rule, benchmark, problems);
  benchmark.reason = fields.text("reason").value_or(Text{});
  const YamlNode* source = fields.find("source");
  if (source) read_source(*source, benchmark, problems);

  if (benchmark.rule == "fixed") {
    benchmark.value = fields.need_number("value", {-kLargest, kLargest});
    if (!source && !fields.find("reason") && entry.value.complete && fields.is_map()) {
      problems.error(entry.key,
                     "benchmark '" + benchmark.id +
                         "' has neither source nor reason: say where its value comes from");
    }
  } else if (!benchmark.rule.empty()) {
    fields.unavailable("value",
                       "the value of this benchmark is computed from its source: take 'value' out");
    if (!source && entry.value.complete) {
      problems.error(entry.key,
                     "benchmark '" + benchmark.id +
                         "' has no source: name the cohort and the apparatus of its data");
    }
  } else {
    fields.find("value");
  }
  fields.finish();
  return benchmark;
}

}  // namespace

bool check_metric(const std::string& id, const YamlNode& at, Problems& problems) {
  if (assessment::find_metric(id)) return true;
  if (std::find(kLaterMetrics.begin(), kLaterMetrics.end(), id) != kLaterMetrics.end()) {
    problems.error(at, "'" + id + "' is not measured by this version of the program: take it out");
    return false;
  }
  std::vector<std::string> known;
  for (const auto& definition : assessment::metric_definitions()) known.emplace_back(definition.id);
  const std::string guess = problems.full() ? "" : nearest(id, known);
  problems.error(at, "there is no metric '" + id.substr(0, 64) + "': " +
                         (guess.empty() ? "write one that exists, such as time_s or force_max_n"
                                        : "did you mean '" + guess + "'?"));
  return false;
}

std::vector<Benchmark> read_benchmarks(const YamlNode& node, Problems& problems) {
  std::vector<Benchmark> benchmarks;
  Fields fields(node, "'benchmarks'", problems);
  for (const YamlEntry& entry : node.entries) {
    if (entry.key.kind == YamlNode::Kind::scalar) {
      benchmarks.push_back(read_benchmark(entry, problems));
    }
  }
  return benchmarks;
}

}  // namespace curricula
