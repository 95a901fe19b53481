#include <algorithm>

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

constexpr std::size_t kColumnsPerPage = 10;

list texts(const std::vector<std::string>& words) {
  list items;
  for (const std::string& word : words) items.push_back(object{{"text", word}});
  return items;
}

// Numbers stand to the right, so that their digits line up.
bool is_numeric(const std::string& cell) {
  return cell.empty() || cell == "\u2013" ||
         cell.find_first_not_of("0123456789.<\u2212 ") == std::string::npos;
}

list cells_of(const std::vector<std::string>& words, const std::vector<bool>& numeric) {
  list items;
  for (std::size_t i = 0; i < words.size(); ++i) {
    items.push_back(object{{"text", words[i]}, {"numeric", data(bool(numeric[i]))}});
  }
  return items;
}

object table_object(const std::string& title, const Table& table) {
  std::vector<bool> numeric(table.columns.size(), !table.rows.empty());
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) numeric[i] = numeric[i] && is_numeric(row[i]);
  }
  list rows;
  for (const auto& row : table.rows) rows.push_back(object{{"cells", cells_of(row, numeric)}});
  object made{{"title", title}};
  made["columns"] = data(cells_of(table.columns, numeric));
  made["rows"] = data(rows);
  return made;
}

// A table of many people in parts that fit on a page; the first column is repeated in each.
void add_in_parts(list& tables, const std::string& title, const Table& table) {
  const std::size_t people = table.columns.size() - 1;
  for (std::size_t begin = 0; begin < std::max<std::size_t>(people, 1); begin += kColumnsPerPage) {
    const std::size_t end = std::min(people, begin + kColumnsPerPage);
    const auto part = [&](const std::vector<std::string>& row) {
      std::vector<std::string> cells = {row.front()};
      for (std::size_t i = begin; i < end; ++i) cells.push_back(row[i + 1]);
      return cells;
    };
    Table some;
    some.columns = part(table.columns);
    for (const auto& row : table.rows) some.rows.push_back(part(row));
    const bool whole = people <= kColumnsPerPage;
    tables.push_back(table_object(whole ? title
                                        : title + ", people " + std::to_string(begin + 1) + " to " +
                                              std::to_string(end) + " of " + std::to_string(people),
                                  some));
  }
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

object chart_object(const Chart& chart, const std::string& big, bool with_table) {
  object made{{"title", chart.title}, {"summary", chart.summary}, {"svg", chart.svg}};
  if (!big.empty()) made["big"] = big;
  if (with_table) made["numbers"] = data(table_object(chart.title, chart.table));
  return made;
}

}  // namespace

std::string comparison_html(const assessment::GroupComparison& comparison,
                            const ComparisonSubject& subject) {
  const std::vector<Chart> charts = comparison_charts(comparison, subject);
  list curves, statistics;
  curves.push_back(chart_object(charts[0], "", false));
  curves.push_back(chart_object(charts[1], "", false));
  statistics.push_back(chart_object(charts[2], "", true));
  statistics.push_back(
      chart_object(charts[3], comparison.effect ? fixed(comparison.effect->g, 2) : "", true));
  statistics.push_back(chart_object(charts[4], p_text(comparison.ranks.p_two_sided), true));

  list tables;
  tables.push_back(table_object("Groups", group_table(comparison)));
  tables.push_back(table_object("Learning, person by person", learning_table(comparison)));
  add_in_parts(tables, "Every trial", trials_table(comparison));

  object page{{"exercise", subject.exercise_title},
              {"dataset", subject.dataset_title},
              {"apparatus", subject.apparatus},
              {"headline", comparison_headline(comparison)},
              {"nesting", comparison.nesting},
              {"separation", comparison.separation},
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
