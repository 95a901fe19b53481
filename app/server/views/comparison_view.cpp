#include "app/server/views/comparison_view.h"

#include <algorithm>

#include "app/server/views/json_views.h"
#include "app/server/views/words.h"

namespace app {
namespace {

using nlohmann::json;

std::string count_words(int number, const char* one, const char* many) {
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

json head_json(const reports::ComparisonSubject& subject) {
  return {{"exercise_id", subject.exercise_id},
          {"exercise_title", subject.exercise_title},
          {"dataset", subject.dataset},
          {"dataset_title", subject.dataset_title},
          {"apparatus", subject.apparatus}};
}

json or_null(const std::optional<double>& value) { return value ? json(*value) : json(); }

json groups_json(const assessment::GroupComparison& comparison) {
  json list = json::array();
  for (const auto* group : {&comparison.first, &comparison.second}) {
    list.push_back({{"level", group->group},
                    {"people", group->participants},
                    {"trials", group->trials},
                    {"mean_s", group->over_participants.mean},
                    {"sd_s", or_null(group->over_participants.standard_deviation)},
                    {"improvement_percent", or_null(group->improvement_percent)}});
  }
  return list;
}

json effect_json(const assessment::GroupComparison& comparison) {
  if (!comparison.effect || !comparison.effect->interval) return nullptr;
  const assessment::HedgesG& effect = *comparison.effect;
  const std::string sentence = "Hedges g, " + comparison.question.first_group + " minus " +
                               comparison.question.second_group + "; " +
                               number_text(effect.interval->confidence * 100.0, 0) +
                               " % interval " + number_text(effect.interval->low, 2) + " to " +
                               number_text(effect.interval->high, 2);
  return {{"hedges_g", effect.g},
          {"low", effect.interval->low},
          {"high", effect.interval->high},
          {"sentence", sentence}};
}

json test_json(const assessment::GroupComparison& comparison) {
  const assessment::RankTest& ranks = comparison.ranks;
  const double u = std::min(ranks.u_first, ranks.u_second);
  const std::string sentence =
      "Mann-Whitney U = " + number_text(u, 1) + ", " +
      (ranks.exact ? "exact" : "normal approximation") + ", two-sided; " +
      count_words(ranks.first_count + ranks.second_count, "person", "people") + ", " +
      count_words(comparison.first.trials + comparison.second.trials, "trial", "trials");
  return {{"u", u}, {"p", ranks.p_two_sided}, {"p_floor", ranks.p_floor}, {"sentence", sentence}};
}

}  // namespace

json comparison_json(const assessment::GroupComparison& comparison,
                     const reports::ComparisonSubject& subject) {
  json answer = head_json(subject);
  answer["enough"] = comparison.first.participants >= 2 && comparison.second.participants >= 2;
  answer["headline"] = reports::comparison_headline(comparison);
  answer["charts"] = to_json(reports::comparison_charts(comparison, subject));
  answer["groups"] = groups_json(comparison);
  answer["effect"] = effect_json(comparison);
  answer["test"] = test_json(comparison);
  answer["learning"] = to_json(reports::learning_table(comparison));
  answer["nesting_sentence"] = comparison.nesting;
  answer["warnings"] = comparison.warnings;
  return answer;
}

json no_comparison_json(const reports::ComparisonSubject& subject, const std::string& why) {
  json answer = head_json(subject);
  answer["enough"] = false;
  answer["headline"] = why;
  answer["charts"] = json::array();
  answer["groups"] = json::array();
  answer["effect"] = nullptr;
  answer["test"] = nullptr;
  answer["learning"] = to_json(reports::Table{});
  answer["nesting_sentence"] = "";
  answer["warnings"] = json::array();
  return answer;
}

}  // namespace app
