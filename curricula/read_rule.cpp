#include "curricula/read_rule.h"

#include <algorithm>

#include "curricula/nearest.h"
#include "curricula/read_benchmarks.h"

namespace curricula {
namespace {

using assessment::Rule;

constexpr double kLargest = 1e9;  // of a bound, in whatever unit
const std::vector<std::string> kSigns = {"<", "<=", "==", "!=", ">=", ">"};

class RuleReader {
 public:
  RuleReader(const RuleContext& context, Problems& problems)
      : context_(context), problems_(problems) {}

  Rule read(const YamlNode& node) {
    if (node.find("all")) return read_children(node, "all", Rule::Kind::all);
    if (node.find("any")) return read_children(node, "any", Rule::Kind::any);
    if (node.find("not")) return read_negation(node);
    if (node.find("metric")) return read_metric(node);
    if (node.find("errors")) return read_errors(node);
    if (node.find("goal")) return read_goal(node);
    if (const YamlNode* rating = node.find("rating")) {
      problems_.error(*rating,
                      "ratings are part of the format, but no pass rule of this version can "
                      "use them: take the rating out");
    } else if (node.kind != YamlNode::Kind::unusable && node.complete) {
      problems_.error(node,
                      "a part of a pass rule needs one of 'all', 'any', 'not', 'metric', "
                      "'errors' or 'goal': write it as {metric: time_s, op: \"<=\", value: 90}");
    }
    return {};
  }

 private:
  Rule read_children(const YamlNode& node, const char* key, Rule::Kind kind) {
    Fields fields(node, std::string("'") + key + "'", problems_);
    Rule rule;
    rule.kind = kind;
    for (const YamlNode* child : fields.need_list(key)) rule.children.push_back(read(*child));
    fields.finish();
    return rule;
  }

  Rule read_negation(const YamlNode& node) {
    Fields fields(node, "'not'", problems_);
    Rule rule;
    rule.kind = Rule::Kind::negate;
    rule.children.push_back(read(*fields.need("not")));
    fields.finish();
    return rule;
  }

  void read_comparison(Fields& fields, Rule& rule) {
    const auto sign = fields.need_choice("op", kSigns);
    if (sign) assessment::parse(kSigns[*sign], rule.comparison);
  }

  Rule read_metric(const YamlNode& node) {
    Fields fields(node, "a criterion on a metric", problems_);
    Rule rule;
    rule.kind = Rule::Kind::metric;
    rule.subject = fields.need_word("metric");
    check_recorded(rule.subject, *fields.find("metric"));
    read_comparison(fields, rule);
    const YamlNode* benchmark = fields.find("benchmark");
    const YamlNode* value = fields.find("value");
    if (benchmark && value) {
      problems_.error(*benchmark,
                      "this criterion has a value and a benchmark: take one of the two out");
    } else if (benchmark) {
      resolve(fields.word("benchmark").value_or(""), *benchmark, rule);
    }
    if (value || !benchmark) rule.bound = fields.need_number("value", {-kLargest, kLargest});
    fields.finish();
    return rule;
  }

  void check_recorded(const std::string& metric, const YamlNode& at) {
    if (metric.empty() || !check_metric(metric, at, problems_)) return;
    const auto& recorded = context_.recorded;
    if (std::find(recorded.begin(), recorded.end(), metric) == recorded.end()) {
      problems_.error(
          at, "'" + metric + "' decides the verdict but is not recorded: add it to 'record'");
    }
  }

  void resolve(const std::string& id, const YamlNode& at, Rule& rule) {
    if (id.empty()) return;
    const auto found = std::find_if(context_.benchmarks.begin(), context_.benchmarks.end(),
                                    [&](const Benchmark& b) { return b.id == id; });
    if (found == context_.benchmarks.end()) {
      if (context_.truncated) return;
      std::vector<std::string> known;  // not gathered when there is nobody left to tell
      for (const Benchmark& b : context_.benchmarks) {
        if (!problems_.full()) known.push_back(b.id);
      }
      const std::string guess = problems_.full() ? "" : nearest(id, known);
      problems_.error(at, "there is no benchmark '" + id + "': " +
                              (guess.empty() ? "define it under 'benchmarks'"
                                             : "did you mean '" + guess + "'?"));
      return;
    }
    rule.benchmark = id;
    rule.bound = found->value;
    rule.provisional = found->provisional;
    if (!found->metric.empty() && found->metric != rule.subject && !rule.subject.empty()) {
      problems_.error(at, "benchmark '" + id + "' is for " + found->metric + ", not for " +
                              rule.subject + ": use a benchmark of the same metric");
    }
    if (!found->rule.empty() && found->rule != "fixed") {
      problems_.error(at, "benchmark '" + id +
                              "' has no value until its cohort has recorded trials: "
                              "use a fixed one, marked provisional, until then");
    }
  }

  Rule read_errors(const YamlNode& node) {
    Fields fields(node, "a criterion on errors", problems_);
    Rule rule;
    rule.kind = Rule::Kind::errors;
    const std::vector<std::string> severities = {"critical", "fail", "mark"};
    const auto severity = fields.need_choice("errors", severities);
    if (severity) rule.subject = severities[*severity];
    read_comparison(fields, rule);
    rule.bound = static_cast<double>(fields.need_integer("value", 0, 1000));
    fields.finish();
    return rule;
  }

  Rule read_goal(const YamlNode& node) {
    Fields fields(node, "a criterion on the goal", problems_);
    Rule rule;
    rule.kind = Rule::Kind::goal;
    if (fields.need_choice("goal", {"reached"})) rule.subject = "reached";
    fields.finish();
    return rule;
  }

  const RuleContext& context_;
  Problems& problems_;
};

}  // namespace

assessment::Rule read_rule(const YamlNode& node, const RuleContext& context, Problems& problems) {
  return RuleReader(context, problems).read(node);
}

}  // namespace curricula
