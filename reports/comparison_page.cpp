#include <kainjow/mustache.hpp>

#include "reports/comparison_report.h"
#include "reports/number.h"
#include "reports/templates.h"

namespace reports {
namespace {

using kainjow::mustache::data;
using kainjow::mustache::list;
using kainjow::mustache::mustache;
using kainjow::mustache::object;

list texts(const std::vector<std::string>& words) {
  list items;
  for (const std::string& word : words) items.push_back(object{{"text", word}});
  return items;
}

object table_object(const std::string& title, const Table& table) {
  list rows;
  for (const auto& row : table.rows) rows.push_back(object{{"cells", texts(row)}});
  return {{"title", title}, {"columns", texts(table.columns)}, {"rows", rows}};
}

// The figures of the sentence above, to two decimals.
Table group_table(const assessment::GroupComparison& comparison) {
  const std::string unit = ", " + comparison.question.unit;
  Table table;
  table.columns = {"Group",
                   "People",
                   "Trials",
                   "Mean" + unit,
                   "SD over people" + unit,
                   "SD over trials" + unit,
                   "Improvement first to last, %"};
  for (const assessment::GroupResult* group : {&comparison.first, &comparison.second}) {
    const auto cell = [](const std::optional<double>& value) {
      return value ? fixed(*value, 2) : std::string("\u2013");
    };
    table.rows.push_back(
        {group->group, std::to_string(group->participants), std::to_string(group->trials),
         fixed(group->over_participants.mean, 2), cell(group->over_participants.standard_deviation),
         cell(group->over_trials.standard_deviation), cell(group->improvement_percent)});
  }
  return table;
}

object chart_object(const Chart& chart, const std::string& big) {
  object made{{"title", chart.title}, {"summary", chart.summary}, {"svg", chart.svg}};
  if (!big.empty()) made["big"] = big;
  return made;
}

}  // namespace

std::string comparison_html(const assessment::GroupComparison& comparison,
                            const ComparisonSubject& subject) {
  const std::vector<Chart> charts = comparison_charts(comparison, subject);
  list curves, statistics;
  curves.push_back(chart_object(charts[0], ""));
  curves.push_back(chart_object(charts[1], ""));
  statistics.push_back(chart_object(charts[2], ""));
  statistics.push_back(
      chart_object(charts[3], comparison.effect ? fixed(comparison.effect->g, 2) : ""));
  statistics.push_back(chart_object(charts[4], p_text(comparison.ranks.p_two_sided)));

  list tables;
  tables.push_back(table_object("Groups", group_table(comparison)));
  tables.push_back(table_object("Learning, person by person", learning_table(comparison)));
  tables.push_back(table_object("Every trial", trials_table(comparison)));

  object page{{"exercise", subject.exercise_title},
              {"dataset", subject.dataset_title},
              {"apparatus", subject.apparatus},
              {"headline", comparison_headline(comparison)},
              {"nesting", comparison.nesting},
              {"data_sha256", subject.data_sha256},
              {"program", subject.program},
              {"rows", std::to_string(comparison.first.trials + comparison.second.trials)}};
  page["curves"] = data(curves);
  page["statistics"] = data(statistics);
  page["warnings"] = data(texts(comparison.warnings));
  page["tables"] = data(tables);
  mustache compiled{comparison_template()};
  return compiled.render(page);
}

}  // namespace reports
