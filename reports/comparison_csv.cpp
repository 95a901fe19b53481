#include "reports/comparison_report.h"
#include "reports/csv.h"
#include "reports/number.h"

namespace reports {
namespace {

using assessment::GroupComparison;
using assessment::GroupResult;

class Rows {
 public:
  void add(const std::string& section, const std::string& who, const std::string& quantity,
           const std::string& value, const std::string& unit) {
    text_ += csv_row({section, who, quantity, value, unit});
  }
  void add(const std::string& section, const std::string& who, const std::string& quantity,
           const std::optional<double>& value, const std::string& unit) {
    add(section, who, quantity, value ? exact(*value) : std::string(), unit);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_ = csv_row({"section", "who", "quantity", "value", "unit"});
};

void add_law(Rows& rows, const std::string& section, const std::string& who,
             const std::optional<assessment::PowerLaw>& law, const std::string& unit) {
  if (!law) return;
  rows.add(section, who, "power_law_a", law->a, unit);
  rows.add(section, who, "power_law_b", law->b, "");
  rows.add(section, who, "learning_rate", law->learning_rate, "");
  rows.add(section, who, "power_law_r_squared", law->r_squared, "");
}

void add_group(Rows& rows, const GroupResult& group, const std::string& unit) {
  rows.add("group", group.group, "participants", std::to_string(group.participants), "");
  rows.add("group", group.group, "trials", std::to_string(group.trials), "");
  rows.add("group", group.group, "mean", group.over_participants.mean, unit);
  rows.add("group", group.group, "sd_over_participants", group.over_participants.standard_deviation,
           unit);
  rows.add("group", group.group, "sd_over_trials", group.over_trials.standard_deviation, unit);
  rows.add("group", group.group, "improvement_percent", group.improvement_percent, "%");
  add_law(rows, "group", group.group, group.power_law, unit);
}

}  // namespace

std::string comparison_csv(const GroupComparison& comparison, const ComparisonSubject& subject) {
  const std::string& unit = comparison.question.unit;
  Rows rows;
  rows.add("subject", "", "exercise", subject.exercise_id, "");
  rows.add("subject", "", "dataset", subject.dataset, "");
  rows.add("subject", "", "apparatus", subject.apparatus, "");
  rows.add("subject", "", "data_sha256", subject.data_sha256, "");
  rows.add("subject", "", "program", subject.program, "");
  for (const auto& person : comparison.participants) {
    for (std::size_t i = 0; i < person.values.size(); ++i) {
      rows.add("trial", person.participant, person.group + " trial " + exact(person.trials[i]),
               person.values[i], unit);
    }
  }
  for (const auto& person : comparison.participants) {
    rows.add("participant", person.participant, "group", person.group, "");
    rows.add("participant", person.participant, "mean", person.summary.mean, unit);
    rows.add("participant", person.participant, "sd", person.summary.standard_deviation, unit);
    rows.add("participant", person.participant, "improvement_percent", person.improvement_percent,
             "%");
    add_law(rows, "participant", person.participant, person.power_law, unit);
  }
  add_group(rows, comparison.first, unit);
  add_group(rows, comparison.second, unit);
  rows.add("test", "participants", "mann_whitney_u", comparison.ranks.u_first, "");
  rows.add("test", "participants",
           comparison.ranks.exact ? "p_exact_two_sided" : "p_asymptotic_two_sided",
           comparison.ranks.p_two_sided, "");
  rows.add("test", "participants", "p_floor", comparison.ranks.p_floor, "");
  if (comparison.effect) {
    rows.add("effect", "participants", "hedges_g", comparison.effect->g, "");
    if (const auto& interval = comparison.effect->interval) {
      rows.add("effect", "participants", "hedges_g_low", interval->low, "");
      rows.add("effect", "participants", "hedges_g_high", interval->high, "");
    }
  }
  if (comparison.difference) {
    rows.add("effect", "participants", "welch_difference", comparison.difference->difference, unit);
    rows.add("effect", "participants", "welch_low", comparison.difference->interval.low, unit);
    rows.add("effect", "participants", "welch_high", comparison.difference->interval.high, unit);
  }
  rows.add("note", "", "nesting", comparison.nesting, "");
  for (const std::string& warning : comparison.warnings)
    rows.add("note", "", "warning", warning, "");
  return rows.text();
}

}  // namespace reports
