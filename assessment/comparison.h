// Two groups of people at the same exercise and metric: novices against experts. One pure function
// on plain rows, which knows nothing of where they are stored.
//
// Trials are nested in people, so the person is the unit of every test: each person counts once,
// by the mean of his or her trials. What is computed over trials is there to describe, not to test.
// Rows of different apparatus, or of published, simulated and live trials, must not be mixed: the
// caller passes the rows of one of them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/metrics.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/effect_size.h"
#include "assessment/statistics/mean_difference.h"
#include "assessment/statistics/power_law.h"
#include "assessment/statistics/rank_test.h"
#include "sim/base/result.h"

namespace assessment {

// One trial of one person.
struct TrialValue {
  std::string group;        // "expert", "novice"
  std::string participant;  // unique across groups
  int trial = 0;            // 1, 2, 3, ... in the order they were made
  double value = 0.0;       // of the metric, in its unit
};

struct ComparisonQuestion {
  std::string first_group = "expert";
  std::string second_group = "novice";
  Direction direction = Direction::lower_is_better;
  std::string unit = "s";
  std::optional<double> pass_mark;  // warns when recorded people of the first group miss it
  double confidence = 0.95;
};

struct ParticipantResult {
  std::string participant;
  std::string group;
  std::vector<double> trials;  // ordinals, ascending
  std::vector<double> values;  // in the order of trials
  Summary summary;
  std::optional<double> improvement_percent;  // first to last, positive: better; absent: one trial
  std::optional<PowerLaw> power_law;          // absent: fewer than three trials
  std::optional<int> passes;                  // trials that meet the pass mark, when there is one
};

// The mean over the people of a group at one trial ordinal.
struct TrialMean {
  int trial = 0;
  int participants = 0;
  double mean = 0.0;
  std::optional<double> standard_deviation;
};

struct GroupResult {
  std::string group;
  int participants = 0;
  int trials = 0;
  Summary over_participants;                  // of the participants' means: what the tests use
  Summary over_trials;                        // of all trials together: describes only
  std::vector<TrialMean> by_trial;            // ordinals that every participant of the group has
  std::optional<double> improvement_percent;  // of the group's mean, first to last of by_trial
  std::optional<PowerLaw> power_law;          // of the means in by_trial
};

struct GroupComparison {
  ComparisonQuestion question;
  std::vector<ParticipantResult> participants;  // first group, then second, each by name
  GroupResult first;
  GroupResult second;

  // On participants' means, first minus second. What cannot be computed is absent, and `warnings`
  // says why.
  RankTest ranks;
  Dominance dominance;
  std::optional<HedgesG> effect;
  std::optional<MeanDifference> difference;
  std::optional<RankTest> improvement_ranks;  // of improvement_percent, where everyone has one

  // Ready to print, in English.
  std::string nesting;                // why the person is the unit, and the floor of p
  std::string separation;             // complete separation in words, or empty
  std::vector<std::string> warnings;  // each one sentence
};

// Fails with not_enough_data when a group has nobody; invalid_input for a value that is not finite,
// an ordinal below 1, a trial given twice or a participant in both groups. Rows of other groups
// are ignored.
base::Result<GroupComparison> compare_groups(std::span<const TrialValue> rows,
                                             const ComparisonQuestion& question = {});

}  // namespace assessment
