// Two rows: every trial as a tick, every person's mean as a marker, the group's mean as a line.
#include <algorithm>

#include "reports/axis.h"
#include "reports/comparison_parts.h"
#include "reports/number.h"
#include "reports/series.h"

namespace reports {
namespace {

using assessment::GroupComparison;
using assessment::GroupResult;
using assessment::ParticipantResult;

constexpr double kWidth = 592.0;
constexpr double kRight = 560.0;
constexpr int kManyTrials = 200;  // their ticks are drawn paler, so that dense places show

using People = std::vector<const ParticipantResult*>;

People people_of(const GroupComparison& comparison, const GroupResult& group) {
  People people;
  for (const ParticipantResult& person : comparison.participants) {
    if (person.group == group.group) people.push_back(&person);
  }
  return people;
}

// The outermost two by name, where the rows are not crowded; the shapes name the others, which are
// those of the curves.
void name_outermost(Svg& svg, const People& people, const Look& look, const Scale& x, double y) {
  if (people.empty() || people.size() > static_cast<std::size_t>(kNamedPeople)) return;
  const auto [low, high] = std::minmax_element(
      people.begin(), people.end(),
      [](const auto* a, const auto* b) { return a->summary.mean < b->summary.mean; });
  const auto name = [&](const ParticipantResult& person, double place, Anchor anchor, double room) {
    const std::string words = shortened(person.participant, room, false, true);
    svg.text({place, y}, words, anchor, colour::kText2, look.css_class + " name", false,
             person.participant);
  };
  const double left = x((*low)->summary.mean) - 11.0;
  const double right = x((*high)->summary.mean) + 11.0;
  if (low != high && left > 112.0) name(**low, left, Anchor::end, left - 80.0);
  if (right < kWidth - 28.0) name(**high, right, Anchor::start, kWidth - 4.0 - right);
}

void draw_row(Svg& svg, const GroupResult& group, const People& people, const Look& base,
              const std::string& title, const std::string& unit, const Scale& x, double top) {
  svg.text({2.0, top + 18.0}, title, Anchor::start, base.colour, base.css_class + " label", true);
  svg.text({2.0, top + 34.0}, counted(group.participants, "person", "people"), Anchor::start,
           colour::kText2, "lab2");
  const double mean = x(group.over_participants.mean);
  const std::string words = plain(group.over_participants.mean) + " " + unit;
  const bool at_edge = mean + 6.0 + text_width(words, true) > kWidth;
  svg.line({mean, top}, {mean, top + 36.0}, {base.colour, 2.0, "", base.css_class});
  svg.text({mean + (at_edge ? -6.0 : 6.0), top + 9.0}, words, at_edge ? Anchor::end : Anchor::start,
           base.colour, base.css_class + " label", true);
  const double opacity = group.trials > kManyTrials ? 0.25 : 1.0;
  const bool crowded = people.size() > static_cast<std::size_t>(kNamedPeople);
  Look look = base;
  for (const ParticipantResult* person : people) {
    for (const double value : person->values) {
      svg.line({x(value), top + 42.0}, {x(value), top + 49.0},
               {look.colour, 1.0, "", look.css_class, opacity});
    }
    draw_marker(svg, {x(person->summary.mean), top + 25.0}, look, crowded ? 3.0 : 5.0);
    if (!crowded) ++look.index;
  }
  name_outermost(svg, people, base, x, top + 29.0);
}

}  // namespace

Chart participant_means(const GroupComparison& comparison, const ComparisonSubject& subject) {
  const std::string& unit = comparison.question.unit;
  Chart made;
  made.id = "participant-means";
  made.title = "Participant means";
  made.summary = "Experts " + plain(comparison.first.over_participants.mean) + ", novices " +
                 plain(comparison.second.over_participants.mean) + " " + unit +
                 ". Marker: mean of one person. Line: group mean. Ticks: single trials.";
  made.table.columns = {"Person", "Group", "Mean " + subject.metric_title + ", " + unit, "Trials"};
  for (const ParticipantResult& person : comparison.participants) {
    made.table.rows.push_back({person.participant, person.group, plain(person.summary.mean),
                               std::to_string(person.summary.count)});
  }

  Svg svg("compare-" + made.id, kWidth, 170.0, made.title, made.summary);
  const ValueRange range = range_of(comparison);
  const std::vector<double> ticks = round_ticks(range.low, range.high, 5);
  const std::vector<std::string> words = tick_texts(ticks);
  const Scale x{ticks.front(), ticks.back(), 110.0, kRight};
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    svg.line({x(ticks[i]), 6.0}, {x(ticks[i]), 136.0}, {colour::kGrid, 1.0, "", "grid"});
    svg.text({x(ticks[i]), 156.0}, i + 1 == ticks.size() ? words[i] + " " + unit : words[i],
             Anchor::middle, colour::kText3, "ax");
  }
  draw_row(svg, comparison.first, people_of(comparison, comparison.first), expert_look(0),
           "Experts", unit, x, 8.0);
  draw_row(svg, comparison.second, people_of(comparison, comparison.second), novice_look(0),
           "Novices", unit, x, 76.0);
  made.svg = svg.finish();
  return made;
}

}  // namespace reports
