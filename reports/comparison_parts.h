// What the drawings of a comparison share. Internal to reports.
#pragma once

#include <string>

#include "assessment/comparison.h"
#include "reports/chart.h"
#include "reports/comparison_report.h"

namespace reports {

// More people than this in a group are drawn as thin lines behind the mean of the group, without a
// name on each: the names are in the tables.
inline constexpr int kNamedPeople = 12;

struct ValueRange {
  double low = 0.0, high = 1.0;
};

// Of all trials of both groups, so that their drawings can be compared by eye.
ValueRange range_of(const assessment::GroupComparison& comparison);

// "1 person", "3 people".
std::string counted(int count, const char* one, const char* many);

Chart group_curves(const assessment::GroupComparison& comparison, const ComparisonSubject& subject,
                   bool experts);
Chart participant_means(const assessment::GroupComparison& comparison,
                        const ComparisonSubject& subject);
Chart effect_chart(const assessment::GroupComparison& comparison);
Chart p_floor_chart(const assessment::GroupComparison& comparison);

}  // namespace reports
