#include "assessment/comparison_sentences.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>

#include "assessment/statistics/step_change.h"

namespace assessment {
namespace {

std::string with_digits(double value, int significant) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%#.*g", significant, value);
  std::string written(text.data());
  if (written.back() == '.') written.pop_back();
  return written;
}

std::string with_unit(double value, const std::string& unit) {
  return with_digits(value, 4) + (unit.empty() ? "" : " " + unit);
}

std::string in_words(int count) {
  static constexpr std::array<const char*, 13> kWords = {"no",   "one",    "two",   "three", "four",
                                                         "five", "six",    "seven", "eight", "nine",
                                                         "ten",  "eleven", "twelve"};
  return count >= 0 && count < static_cast<int>(kWords.size())
             ? kWords[static_cast<std::size_t>(count)]
             : std::to_string(count);
}

std::string capitalised(std::string text) {
  if (!text.empty()) {
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  }
  return text;
}

std::string plural(int count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string nesting_sentence(const GroupComparison& comparison) {
  const int n1 = comparison.first.participants, n2 = comparison.second.participants;
  const int trials = comparison.first.trials + comparison.second.trials;
  return "Trials are nested in people, so the person is the unit: the " + plural(trials, "trial") +
         " here come from " + (n1 + n2 == 2 ? "two people" : std::to_string(n1 + n2) + " people") +
         ". " + capitalised(in_words(n1)) + " against " + in_words(n2) +
         " can never give an exact rank p below " + with_digits(comparison.ranks.p_floor, 2) +
         ", however many trials each of them makes.";
}

std::string separation_sentence(const GroupComparison& comparison) {
  if (!comparison.dominance.complete_separation) return {};
  const bool below = comparison.dominance.first_lower == 1.0;
  return "The groups are completely separated: the mean of every " +
         comparison.question.first_group + " lies " + (below ? "below" : "above") +
         " that of every " + comparison.question.second_group +
         ". How far they overlap in general cannot be estimated from these people, so Cliff's "
         "delta has no interval.";
}

int trials_that_meet(const ParticipantResult& person, double mark, Direction direction) {
  return static_cast<int>(
      std::count_if(person.values.begin(), person.values.end(), [&](double value) {
        return direction == Direction::lower_is_better ? value <= mark : value >= mark;
      }));
}

// A pass mark that a recorded expert never meets is a mark to think about again.
void warn_about_mark(GroupComparison& comparison, double mark, const std::string& name) {
  for (const ParticipantResult& person : comparison.participants) {
    if (person.group != comparison.question.first_group) continue;
    if (trials_that_meet(person, mark, comparison.question.direction) > 0) continue;
    comparison.warnings.push_back(name + " (" + with_unit(mark, comparison.question.unit) +
                                  ") fails " + person.group + " " + person.participant +
                                  ", who meets it in 0 of " +
                                  plural(static_cast<int>(person.values.size()), "trial") + ".");
  }
}

// How much better, in AICc, a step must describe a series than the power law before we say so.
// 10 leaves the worse model "essentially no support" (Burnham and Anderson 2002, section 2.6).
constexpr double kClearlyBetter = 10.0;

void warn_about_steps(GroupComparison& comparison) {
  for (const ParticipantResult& person : comparison.participants) {
    const auto count = static_cast<int>(person.values.size());
    if (count < 6 || !person.power_law) continue;
    const auto step = find_step_change(person.values);
    if (!step || !(step->residual_squares > 0.0)) continue;
    const double deviation = person.power_law->residual_deviation;
    const double curve_squares = deviation * deviation * (count - 2);
    if (!(curve_squares > 0.0)) continue;
    if (aicc(step->residual_squares, count, 4) + kClearlyBetter > aicc(curve_squares, count, 3)) {
      continue;
    }
    const auto last = static_cast<std::size_t>(step->last_before - 1);
    comparison.warnings.push_back(
        person.participant + " changes in one step after trial " +
        with_digits(person.trials[last],
                    1 + (person.trials[last] >= 10.0) + (person.trials[last] >= 100.0)) +
        ", from a mean of " + with_unit(step->mean_before, comparison.question.unit) + " to " +
        with_unit(step->mean_after, comparison.question.unit) +
        ": look at the person's own curve, a group mean hides it.");
  }
}

void warn_about_counts(GroupComparison& comparison) {
  const auto [fewest, most] =
      std::minmax_element(comparison.participants.begin(), comparison.participants.end(),
                          [](const ParticipantResult& x, const ParticipantResult& y) {
                            return x.values.size() < y.values.size();
                          });
  if (fewest->values.size() != most->values.size()) {
    comparison.warnings.push_back(
        "Participants made between " + std::to_string(fewest->values.size()) + " and " +
        std::to_string(most->values.size()) +
        " trials; means by trial cover the trials that everyone of a group has.");
  }
  if (!comparison.ranks.exact) {
    comparison.warnings.push_back(
        "The groups are too large for an exact p: it is asymptotic (normal approximation).");
  }
}

void warn_about_fits(GroupComparison& comparison) {
  for (const ParticipantResult& person : comparison.participants) {
    if (!person.power_law) {
      comparison.warnings.push_back(person.participant + " has too few trials for a power law.");
    } else if (person.power_law->at_bound || person.power_law->not_identified) {
      comparison.warnings.push_back("The power law of " + person.participant +
                                    " does not describe the trials: its exponent is not "
                                    "determined by them.");
    }
  }
}

}  // namespace

void add_sentences(GroupComparison& comparison) {
  comparison.nesting = nesting_sentence(comparison);
  comparison.separation = separation_sentence(comparison);
  if (comparison.question.pass_mark) {
    warn_about_mark(comparison, *comparison.question.pass_mark, "The pass mark");
  }
  warn_about_mark(comparison, comparison.first.over_participants.mean,
                  "A pass mark at the mean of the " + comparison.question.first_group + "s");
  warn_about_counts(comparison);
  warn_about_fits(comparison);
  warn_about_steps(comparison);
}

}  // namespace assessment
