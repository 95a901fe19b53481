// The sentence that answers the question first.
#include <algorithm>
#include <cmath>

#include "reports/comparison_report.h"
#include "reports/number.h"

namespace reports {
namespace {

using assessment::GroupComparison;

// Times are faster or slower; of anything else, only its direction says which is better.
std::string verdict_word(const GroupComparison& comparison, double difference) {
  const bool lower = difference < 0.0;
  const bool lower_is_better =
      comparison.question.direction == assessment::Direction::lower_is_better;
  if (comparison.question.unit == "s" && lower_is_better) return lower ? "faster" : "slower";
  return lower == lower_is_better ? "better" : "worse";
}

std::string interval_text(const assessment::MeanDifference& d, const std::string& unit,
                          int decimals) {
  const std::string name = "(" + fixed(d.interval.confidence * 100.0, 0) + " % Welch interval ";
  const bool holds_zero = d.interval.low <= 0.0 && d.interval.high >= 0.0;
  if (holds_zero) {
    return name + "of the difference " + fixed(d.interval.low, decimals) + " to " +
           fixed(d.interval.high, decimals) + " " + unit + ", which includes no difference)";
  }
  const double near = std::min(std::abs(d.interval.low), std::abs(d.interval.high));
  const double far = std::max(std::abs(d.interval.low), std::abs(d.interval.high));
  return name + fixed(near, decimals) + " to " + fixed(far, decimals) + " " + unit + ")";
}

}  // namespace

std::string comparison_headline(const GroupComparison& comparison) {
  const double expert = comparison.first.over_participants.mean;
  const double novice = comparison.second.over_participants.mean;
  const std::string& unit = comparison.question.unit;
  const double difference = expert - novice;
  const int decimals = std::min(plain_decimals(expert), plain_decimals(novice));
  const bool alike = fixed(difference, decimals) == fixed(0.0, decimals);
  std::string text;
  if (alike) {
    text = "Experts and novices did not differ: " + fixed(expert, decimals) + " " + unit +
           " each on average";
  } else {
    text = "Experts were " + verdict_word(comparison, difference) + ": " + fixed(expert, decimals) +
           " " + unit + " against " + fixed(novice, decimals) + " " + unit + " on average, " +
           fixed(std::abs(difference), decimals) + " " + unit +
           (difference < 0.0 ? " less" : " more");
  }
  if (comparison.difference) text += " " + interval_text(*comparison.difference, unit, decimals);
  text += ".";
  if (comparison.dominance.complete_separation) {
    const bool lower = comparison.dominance.first_lower == 1.0;
    text += std::string(" Every expert's mean lies ") + (lower ? "below" : "above") +
            " every novice's.";
  }
  return text;
}

}  // namespace reports
