#include <algorithm>
#include <set>

#include "reports/comparison_report.h"
#include "reports/number.h"

namespace reports {

using assessment::GroupComparison;
using assessment::GroupResult;
using assessment::ParticipantResult;

namespace {

std::string optional_text(const std::optional<double>& value, int decimals) {
  return value ? fixed(*value, decimals) : "\u2013";
}

std::vector<std::string> law_cells(const std::optional<assessment::PowerLaw>& law) {
  if (!law) return {"\u2013", "\u2013", "\u2013"};
  std::string form = "T = " + fixed(law->a, 1) + " n^" + fixed(-law->b, 3);
  if (law->at_bound) form += " (at its bound)";
  return {form, fixed(law->learning_rate, 3),
          law->r_squared ? fixed(*law->r_squared, 2) : "\u2013"};
}

std::vector<std::string> person_row(const ParticipantResult& person) {
  std::vector<std::string> row = {person.participant,
                                  person.group,
                                  std::to_string(person.summary.count),
                                  fixed(person.summary.mean, 1),
                                  optional_text(person.summary.standard_deviation, 1),
                                  fixed(person.values.front(), 1),
                                  fixed(person.values.back(), 1),
                                  optional_text(person.improvement_percent, 1)};
  for (std::string& cell : law_cells(person.power_law)) row.push_back(std::move(cell));
  return row;
}

std::vector<std::string> group_row(const GroupResult& group, const char* name) {
  const bool curve = !group.by_trial.empty();
  std::vector<std::string> row = {name,
                                  group.group,
                                  std::to_string(group.trials),
                                  fixed(group.over_participants.mean, 1),
                                  optional_text(group.over_participants.standard_deviation, 1),
                                  curve ? fixed(group.by_trial.front().mean, 1) : "\u2013",
                                  curve ? fixed(group.by_trial.back().mean, 1) : "\u2013",
                                  optional_text(group.improvement_percent, 1)};
  for (std::string& cell : law_cells(group.power_law)) row.push_back(std::move(cell));
  return row;
}

}  // namespace

Table learning_table(const GroupComparison& comparison) {
  const std::string unit = ", " + comparison.question.unit;
  Table table;
  table.columns = {"Person",    "Group",         "Trials",      "Mean" + unit,
                   "SD" + unit, "First" + unit,  "Last" + unit, "Improvement, %",
                   "Power law", "Learning rate", "R\u00b2"};
  for (const ParticipantResult& person : comparison.participants) {
    table.rows.push_back(person_row(person));
  }
  table.rows.push_back(group_row(comparison.first, "All experts"));
  table.rows.push_back(group_row(comparison.second, "All novices"));
  return table;
}

Table trials_table(const GroupComparison& comparison) {
  Table table;
  table.columns = {"Trial"};
  std::set<int> ordinals;
  for (const ParticipantResult& person : comparison.participants) {
    table.columns.push_back(person.participant + " (" + person.group + ")");
    for (const double trial : person.trials) ordinals.insert(static_cast<int>(trial));
  }
  std::vector<double> all;
  for (const ParticipantResult& person : comparison.participants) {
    all.insert(all.end(), person.values.begin(), person.values.end());
  }
  const int decimals = common_decimals(all, 3);
  for (const int ordinal : ordinals) {
    std::vector<std::string> row = {std::to_string(ordinal)};
    for (const ParticipantResult& person : comparison.participants) {
      const auto at = std::find(person.trials.begin(), person.trials.end(), ordinal);
      row.push_back(at == person.trials.end()
                        ? ""
                        : fixed(person.values[static_cast<std::size_t>(at - person.trials.begin())],
                                decimals));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace reports
