#include "assessment/comparison.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "assessment/comparison_sentences.h"

namespace assessment {
namespace {

using base::Error;
using base::ErrorCode;

// No.2 before No.10: runs of digits compare by their number.
bool in_natural_order(const std::string& left, const std::string& right) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, j = 0;
  while (i < left.size() && j < right.size()) {
    if (digit(left[i]) && digit(right[j])) {
      const auto run = [&](const std::string& text, std::size_t& at) {
        while (at + 1 < text.size() && text[at] == '0' && digit(text[at + 1])) ++at;
        const std::size_t begin = at;
        while (at < text.size() && digit(text[at])) ++at;
        return text.substr(begin, at - begin);
      };
      const std::string a = run(left, i), b = run(right, j);
      if (a.size() != b.size()) return a.size() < b.size();
      if (a != b) return a < b;
    } else {
      if (left[i] != right[j]) return left[i] < right[j];
      ++i;
      ++j;
    }
  }
  const std::size_t left_rest = left.size() - i, right_rest = right.size() - j;
  return left_rest != right_rest ? left_rest < right_rest : left < right;
}

std::optional<double> improvement(double first, double last, Direction direction) {
  if (first == 0.0) return std::nullopt;
  const double gain = direction == Direction::lower_is_better ? first - last : last - first;
  return 100.0 * gain / std::abs(first);
}

std::optional<PowerLaw> power_law_of(std::span<const double> trials, std::span<const double> values,
                                     double confidence) {
  auto fit = fit_power_law(trials, values, PowerLawScale::raw, confidence);
  return fit ? std::optional(*fit) : std::nullopt;
}

bool meets(double value, double mark, Direction direction) {
  return direction == Direction::lower_is_better ? value <= mark : value >= mark;
}

base::Result<ParticipantResult> describe_participant(std::vector<const TrialValue*> rows,
                                                     const ComparisonQuestion& question) {
  std::sort(rows.begin(), rows.end(),
            [](const TrialValue* x, const TrialValue* y) { return x->trial < y->trial; });
  ParticipantResult result;
  result.participant = rows.front()->participant;
  result.group = rows.front()->group;
  for (const TrialValue* row : rows) {
    if (row->group != result.group) {
      return Error{ErrorCode::invalid_input, result.participant + " is in both groups"};
    }
    if (row->trial < 1) {
      return Error{ErrorCode::invalid_input,
                   "a trial of " + result.participant + " has a number below 1"};
    }
    if (!result.trials.empty() && result.trials.back() == row->trial) {
      return Error{ErrorCode::invalid_input, "trial " + std::to_string(row->trial) + " of " +
                                                 result.participant + " is given twice"};
    }
    result.trials.push_back(row->trial);
    result.values.push_back(row->value);
  }
  auto summary = summarise(result.values);
  if (!summary) {
    return Error{summary.error().code, result.participant + ": " + summary.error().message};
  }
  result.summary = *summary;
  if (result.values.size() > 1) {
    result.improvement_percent =
        improvement(result.values.front(), result.values.back(), question.direction);
  }
  result.power_law = power_law_of(result.trials, result.values, question.confidence);
  if (question.pass_mark) {
    result.passes = static_cast<int>(std::count_if(
        result.values.begin(), result.values.end(),
        [&](double value) { return meets(value, *question.pass_mark, question.direction); }));
  }
  return result;
}

// Means over the people at each ordinal that all of them have: a mean over different people at
// each trial would draw a curve that nobody went through.
std::vector<TrialMean> means_by_trial(std::span<const ParticipantResult* const> people) {
  std::map<int, std::vector<double>> by_ordinal;
  for (const ParticipantResult* person : people) {
    for (std::size_t i = 0; i < person->values.size(); ++i) {
      by_ordinal[static_cast<int>(person->trials[i])].push_back(person->values[i]);
    }
  }
  std::vector<TrialMean> means;
  for (const auto& [trial, values] : by_ordinal) {
    if (values.size() != people.size()) continue;
    const auto summary = summarise(values);
    means.push_back({trial, summary->count, summary->mean, summary->standard_deviation});
  }
  return means;
}

GroupResult describe_group(const std::string& name, std::span<const ParticipantResult> participants,
                           const ComparisonQuestion& question) {
  std::vector<const ParticipantResult*> people;
  std::vector<double> means, all_values;
  for (const ParticipantResult& person : participants) {
    if (person.group != name) continue;
    people.push_back(&person);
    means.push_back(person.summary.mean);
    all_values.insert(all_values.end(), person.values.begin(), person.values.end());
  }
  GroupResult group;
  group.group = name;
  group.participants = static_cast<int>(people.size());
  group.trials = static_cast<int>(all_values.size());
  group.over_participants = *summarise(means);
  group.over_trials = *summarise(all_values);
  group.by_trial = means_by_trial(people);

  std::vector<double> trials, values;
  for (const TrialMean& mean : group.by_trial) {
    trials.push_back(mean.trial);
    values.push_back(mean.mean);
  }
  if (values.size() > 1) {
    group.improvement_percent = improvement(values.front(), values.back(), question.direction);
  }
  group.power_law = power_law_of(trials, values, question.confidence);
  return group;
}

std::vector<double> means_of(const GroupComparison& comparison, const std::string& group) {
  std::vector<double> means;
  for (const ParticipantResult& person : comparison.participants) {
    if (person.group == group) means.push_back(person.summary.mean);
  }
  return means;
}

// Empty unless everyone of the group has an improvement.
std::vector<double> improvements_of(const GroupComparison& comparison, const std::string& group) {
  std::vector<double> improvements;
  for (const ParticipantResult& person : comparison.participants) {
    if (person.group != group) continue;
    if (!person.improvement_percent) return {};
    improvements.push_back(*person.improvement_percent);
  }
  return improvements;
}

// The tests, on one value per person.
void test_groups(GroupComparison& comparison) {
  const ComparisonQuestion& question = comparison.question;
  const std::vector<double> first = means_of(comparison, question.first_group);
  const std::vector<double> second = means_of(comparison, question.second_group);
  comparison.ranks = *rank_test(first, second);
  comparison.dominance = *dominance(first, second);

  const auto effect = hedges_g(first, second, question.confidence);
  if (effect) {
    comparison.effect = *effect;
  } else {
    comparison.warnings.push_back("There is no effect size: " + effect.error().message + ".");
  }
  const auto difference = welch(first, second, question.confidence);
  if (difference) {
    comparison.difference = *difference;
  } else {
    comparison.warnings.push_back(
        "There is no interval of the difference: " + difference.error().message + ".");
  }
  const std::vector<double> first_gains = improvements_of(comparison, question.first_group);
  const std::vector<double> second_gains = improvements_of(comparison, question.second_group);
  if (!first_gains.empty() && !second_gains.empty()) {
    comparison.improvement_ranks = *rank_test(first_gains, second_gains);
  }
}

}  // namespace

base::Result<GroupComparison> compare_groups(std::span<const TrialValue> rows,
                                             const ComparisonQuestion& question) {
  if (question.first_group == question.second_group) {
    return Error{ErrorCode::invalid_input, "a group cannot be compared with itself"};
  }
  std::map<std::string, std::vector<const TrialValue*>, decltype(&in_natural_order)> people(
      &in_natural_order);
  for (const TrialValue& row : rows) {
    if (row.group != question.first_group && row.group != question.second_group) continue;
    people[row.participant].push_back(&row);
  }

  GroupComparison comparison;
  comparison.question = question;
  for (auto& [name, rows_of_person] : people) {
    auto person = describe_participant(std::move(rows_of_person), question);
    if (!person) return person.error();
    comparison.participants.push_back(*std::move(person));
  }
  std::stable_partition(
      comparison.participants.begin(), comparison.participants.end(),
      [&](const ParticipantResult& person) { return person.group == question.first_group; });
  for (const std::string& group : {question.first_group, question.second_group}) {
    if (means_of(comparison, group).empty()) {
      return Error{ErrorCode::not_enough_data, "the group \"" + group + "\" has no trial yet"};
    }
  }

  comparison.first = describe_group(question.first_group, comparison.participants, question);
  comparison.second = describe_group(question.second_group, comparison.participants, question);
  test_groups(comparison);
  add_sentences(comparison);
  return comparison;
}

}  // namespace assessment
