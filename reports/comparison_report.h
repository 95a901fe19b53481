// Novices against experts at one exercise: the paper's Figures 6 to 9 and Tables VI and VII, for
// any data of one apparatus. Order everywhere: points per person, participant means, effect with
// interval, p with its floor, the sentence on nesting.
#pragma once

#include <string>
#include <vector>

#include "assessment/comparison.h"
#include "reports/chart.h"

namespace reports {

struct ComparisonSubject {
  std::string exercise_id;
  std::string exercise_title;
  std::string dataset;                // paper | live | simulated
  std::string dataset_title;          // "Published data, 2017: six participants"
  std::string apparatus;              // whose simulator the trials were made on
  std::string data_sha256;            // over the rows, for the footer
  std::string program;                // version and build, for the footer
  std::string metric_title = "Time";  // what was measured in each trial, for headings
};

// One sentence that answers the question first.
std::string comparison_headline(const assessment::GroupComparison& comparison);

// In order: experts, novices (one curve per participant over trials), participant-means, effect,
// p-floor. Ids exactly these.
std::vector<Chart> comparison_charts(const assessment::GroupComparison& comparison,
                                     const ComparisonSubject& subject);

// Per person and group: mean, SD, first, last, improvement, power law T = a n^-b, learning rate.
Table learning_table(const assessment::GroupComparison& comparison);
// The trials as the paper's Tables VI and VII print them: a row per trial, a column per person.
Table trials_table(const assessment::GroupComparison& comparison);

// A complete page that prints well (A4 and Letter) and opens without a network.
std::string comparison_html(const assessment::GroupComparison& comparison,
                            const ComparisonSubject& subject);
// The same numbers as CSV: UTF-8, dot decimals, guarded against formula injection.
std::string comparison_csv(const assessment::GroupComparison& comparison,
                           const ComparisonSubject& subject);

}  // namespace reports
