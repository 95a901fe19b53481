// One curve per participant over trials 1, 2, 3, ...
#include <algorithm>
#include <cmath>

#include "reports/axis.h"
#include "reports/comparison_parts.h"
#include "reports/number.h"
#include "reports/series.h"

namespace reports {
namespace {

using assessment::GroupComparison;
using assessment::GroupResult;
using assessment::ParticipantResult;

constexpr double kWidth = 594.0;
constexpr double kHeight = 326.0;

int last_trial(const GroupComparison& comparison) {
  int last = 2;
  for (const ParticipantResult& person : comparison.participants) {
    if (!person.trials.empty()) last = std::max(last, static_cast<int>(person.trials.back()));
  }
  return last;
}

Table values_table(const GroupComparison& comparison, const std::string& group,
                   const std::string& heading) {
  Table table;
  table.columns = {"Person", "Trial", heading};
  for (const ParticipantResult& person : comparison.participants) {
    if (person.group != group) continue;
    const int decimals = common_decimals(person.values, 3);
    for (std::size_t i = 0; i < person.values.size(); ++i) {
      table.rows.push_back(
          {person.participant, fixed(person.trials[i], 0), fixed(person.values[i], decimals)});
    }
  }
  return table;
}

std::string summary_of(const GroupResult& group, const std::string& unit) {
  std::string text = counted(group.participants, "person", "people") + ", " +
                     counted(group.trials, "trial", "trials") + "; group mean " +
                     plain(group.over_participants.mean) + " " + unit;
  if (const auto& percent = group.improvement_percent) {
    text += ", first to last trial " + fixed(std::abs(*percent), 1) +
            (*percent < 0.0 ? " % worse" : " % better");
  }
  return text + ".";
}

void draw_trial_axis(Svg& svg, const Frame& frame, const Scale& x, int last) {
  const double y = kHeight - frame.bottom + 20.0;
  const int step = last <= 12 ? 1 : (last <= 30 ? 5 : (last <= 120 ? 10 : last / 10));
  for (int n = 1; n <= last; ++n) {
    const bool named = n == 1 || n == last || n % step == 0;
    if (!named || (n != last && last - n < (step + 1) / 2)) continue;
    svg.text({x(n), y}, std::to_string(n), Anchor::middle, colour::kText3, "ax");
  }
  svg.text({kWidth - frame.right + 12.0, y}, "trial", Anchor::start, colour::kText3, "ax");
}

std::vector<Point> places_of(const ParticipantResult& person, const Scale& x, const Scale& y) {
  std::vector<Point> places;
  for (std::size_t i = 0; i < person.values.size(); ++i) {
    places.push_back({x(person.trials[i]), y(person.values[i])});
  }
  return places;
}

// Everyone's trials stay visible as thin lines and small dots; the mean of the group leads.
void draw_crowd(Svg& svg, const GroupResult& group, const std::vector<std::vector<Point>>& people,
                const Look& look, const Scale& x, const Scale& y, std::vector<EndLabel>& labels) {
  for (const auto& places : people) {
    svg.polyline(places, {look.colour, 0.75, "", look.css_class, 0.35});
    for (const Point& place : places) {
      svg.line({place.x - 1.25, place.y}, {place.x + 1.25, place.y},
               {look.colour, 2.5, "", look.css_class, 0.35});
    }
  }
  std::vector<Point> mean;
  for (const assessment::TrialMean& at : group.by_trial) mean.push_back({x(at.trial), y(at.mean)});
  if (mean.empty()) return;
  svg.polyline(mean, {colour::kSurface, 5.0, "", "halo"});
  svg.polyline(mean, {look.colour, 2.5, "", look.css_class});
  draw_marker(svg, mean.back(), look, 4.0);
  labels.push_back({mean.back().y, "mean of " + std::to_string(group.participants), look.colour,
                    look.css_class + " label"});
}

}  // namespace

Chart group_curves(const GroupComparison& comparison, const ComparisonSubject& subject,
                   bool experts) {
  const GroupResult& group = experts ? comparison.first : comparison.second;
  const std::string& unit = comparison.question.unit;
  Chart made;
  made.id = experts ? "experts" : "novices";
  made.title = experts ? "Experts" : "Novices";
  made.summary = summary_of(group, unit);
  made.table = values_table(comparison, group.group, subject.metric_title + ", " + unit);

  Svg svg("compare-" + made.id, kWidth, kHeight,
          made.title + ": " + subject.metric_title + " per trial, one curve per person",
          made.summary);
  Frame frame;
  frame.right = 100.0;
  const ValueRange range = range_of(comparison);
  const Scale y = draw_value_axis(svg, frame, range.low, range.high, unit);
  const int last = last_trial(comparison);
  const Scale x{1.0, static_cast<double>(last), frame.left + 16.0, kWidth - frame.right - 10.0};
  draw_trial_axis(svg, frame, x, last);

  std::vector<EndLabel> labels;
  std::vector<std::vector<Point>> crowd;
  std::size_t index = 0;
  const double size = last > 30 ? 2.0 : (group.participants > 6 || last > 15 ? 3.0 : 4.0);
  for (const ParticipantResult& person : comparison.participants) {
    if (person.group != group.group || person.values.empty()) continue;
    std::vector<Point> places = places_of(person, x, y);
    if (group.participants > kNamedPeople) {
      crowd.push_back(std::move(places));
      continue;
    }
    const Look look = experts ? expert_look(index) : novice_look(index);
    ++index;
    draw_series(svg, places, look, size);
    labels.push_back({places.back().y, person.participant, look.colour, look.css_class + " label"});
  }
  if (!crowd.empty()) {
    draw_crowd(svg, group, crowd, experts ? expert_look(0) : novice_look(0), x, y, labels);
  }
  draw_end_labels(svg, kWidth - frame.right + 6.0, labels, frame.top, kHeight - frame.bottom);
  made.svg = svg.finish();
  return made;
}

}  // namespace reports
