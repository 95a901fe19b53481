#include "app/server/views/words.h"

#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

#include "assessment/metrics.h"

namespace app {
namespace {

using assessment::Comparison;
using assessment::Rule;

const char* comparison_words(Comparison comparison) {
  switch (comparison) {
    case Comparison::less:
      return "below";
    case Comparison::less_equal:
      return "at most";
    case Comparison::equal:
      return "exactly";
    case Comparison::not_equal:
      return "other than";
    case Comparison::greater_equal:
      return "at least";
    case Comparison::greater:
      return "above";
  }
  return "";
}

std::string lower_first(std::string text) {
  // an abbreviation such as SPARC keeps its capitals
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])) != 0) {
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  }
  return text;
}

// "errors: critical" is stored in a rule as the severity alone, in a criterion with its prefix.
std::string full_subject(const Rule& rule) {
  switch (rule.kind) {
    case Rule::Kind::errors:
      return rule.subject.starts_with("errors.") ? rule.subject : "errors." + rule.subject;
    case Rule::Kind::goal:
      return rule.subject.starts_with("goal.") ? rule.subject : "goal." + rule.subject;
    default:
      return rule.subject;
  }
}

std::string leaf_words(const Rule& rule) {
  const std::string subject = full_subject(rule);
  const std::string title = lower_first(subject_title(subject));
  if (rule.kind == Rule::Kind::goal) return title;
  if (rule.kind == Rule::Kind::errors && rule.comparison == Comparison::equal &&
      rule.bound == 0.0) {
    return "no " + title.substr(0, title.size() - 1);  // critical errors -> no critical error
  }
  const std::string unit = subject_unit(subject);
  return title + " " + comparison_words(rule.comparison) + " " + number_text(rule.bound, 2) +
         (unit.empty() ? "" : " " + unit) + (rule.provisional ? " (provisional)" : "");
}

std::string rule_words(const Rule& rule) {
  std::string joined;
  switch (rule.kind) {
    case Rule::Kind::metric:
    case Rule::Kind::errors:
    case Rule::Kind::goal:
      return leaf_words(rule);
    case Rule::Kind::negate:
      joined = "not: ";
      break;
    case Rule::Kind::all:
    case Rule::Kind::any:
      break;
  }
  const std::string glue = rule.kind == Rule::Kind::any ? " or " : " and ";
  for (std::size_t i = 0; i < rule.children.size(); ++i) {
    const Rule& child = rule.children[i];
    const bool nested = !child.children.empty() && rule.children.size() > 1;
    if (i > 0) joined += glue;
    joined += nested ? "(" + rule_words(child) + ")" : rule_words(child);
  }
  return joined;
}

constexpr std::array kPlainEvents = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"first_motion", "The hand moves for the first time; the clock starts"},
    {"paused", "Paused"},
    {"resumed", "Resumed"},
    {"timeout", "The time ran out"},
});

}  // namespace

std::string english(const curricula::Text& text) {
  const auto found = text.find("en");
  return found == text.end() ? std::string{} : found->second;
}

std::string capitalised(std::string word) {
  for (char& character : word) {
    if (character == '-' || character == '_') character = ' ';
  }
  if (!word.empty()) word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  return word;
}

std::string subject_title(const std::string& subject) {
  if (const auto* metric = assessment::find_metric(subject)) return std::string(metric->title);
  if (subject == "goal.reached") return "Goal reached";
  if (subject.starts_with("errors.")) return capitalised(subject.substr(7)) + " errors";
  return capitalised(subject);
}

std::string subject_unit(const std::string& subject) {
  const auto* metric = assessment::find_metric(subject);
  return metric == nullptr ? std::string{} : std::string(metric->unit);
}

std::string rule_sentence(const Rule& rule) { return "Passed with " + rule_words(rule) + "."; }

std::string step_title(const std::string& step_id, const std::vector<curricula::Step>& steps) {
  const std::vector<std::string> titles = curricula::describe_all(steps);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].id == step_id) return titles[i];
  }
  return step_id;
}

std::string event_text(const assessment::Event& event, const std::vector<curricula::Step>& steps) {
  for (const auto& [code, text] : kPlainEvents) {
    if (event.code == code) return std::string(text);
  }
  if (event.code == "step_started") return "Begun: " + step_title(event.detail, steps);
  if (event.code == "step_done") return "Done: " + step_title(event.detail, steps);
  if (event.code == "wall_hit") return "Wall hit, " + number_text(event.value, 2) + " N";
  if (event.code == "limit_breached") {
    const std::string unit = subject_unit(event.detail);
    return "Limit passed: " + lower_first(subject_title(event.detail)) + " " +
           number_text(event.value, 2) + (unit.empty() ? "" : " " + unit);
  }
  if (event.code == "ended") return "Ended: " + event.detail;
  return capitalised(event.code);
}

std::string number_text(double value, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  std::string written = text.data();
  if (written.find('.') != std::string::npos) {
    written.erase(written.find_last_not_of('0') + 1);
    if (written.back() == '.') written.pop_back();
  }
  return written == "-0" ? "0" : written;
}

}  // namespace app
