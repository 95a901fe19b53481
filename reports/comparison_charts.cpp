#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "assessment/statistics/rank_test.h"
#include "reports/axis.h"
#include "reports/comparison_report.h"
#include "reports/number.h"
#include "reports/series.h"

namespace reports {
namespace {

using assessment::GroupComparison;
using assessment::GroupResult;
using assessment::ParticipantResult;

constexpr double kCurveWidth = 594.0;
constexpr double kCurveHeight = 326.0;

std::string plural(int count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

struct Range {
  double low = 0.0, high = 1.0;
};

// Both groups share it, so that the two drawings can be compared by eye.
Range range_of(const GroupComparison& comparison) {
  Range range{1e300, -1e300};
  for (const ParticipantResult& person : comparison.participants) {
    range.low = std::min(range.low, person.summary.minimum);
    range.high = std::max(range.high, person.summary.maximum);
  }
  if (range.low > range.high) return {0.0, 1.0};
  if (range.high <= range.low) range.high = range.low + 1.0;
  return range;
}

int last_trial(const GroupComparison& comparison) {
  int last = 2;
  for (const ParticipantResult& person : comparison.participants) {
    if (!person.trials.empty()) last = std::max(last, static_cast<int>(person.trials.back()));
  }
  return last;
}

Table values_table(const GroupComparison& comparison, const std::string& group) {
  Table table;
  table.columns = {"Person", "Trial", "Time, " + comparison.question.unit};
  for (const ParticipantResult& person : comparison.participants) {
    if (person.group != group) continue;
    for (std::size_t i = 0; i < person.values.size(); ++i) {
      table.rows.push_back(
          {person.participant, fixed(person.trials[i], 0), plain(person.values[i])});
    }
  }
  return table;
}

Chart group_curves(const GroupComparison& comparison, const GroupResult& group, bool experts) {
  Chart made;
  made.id = experts ? "experts" : "novices";
  made.title = experts ? "Experts" : "Novices";
  made.summary = plural(group.participants, "person", "people") + ", " +
                 plural(group.trials, "trial", "trials") + "; group mean " +
                 plain(group.over_participants.mean) + " " + comparison.question.unit +
                 (group.improvement_percent ? ", first to last trial " +
                                                  fixed(*group.improvement_percent, 1) + " % better"
                                            : "") +
                 ".";
  made.table = values_table(comparison, group.group);

  Svg svg("compare-" + made.id, kCurveWidth, kCurveHeight,
          made.title + ": time per trial, one curve per person", made.summary);
  Frame frame;
  frame.right = 100.0;
  const Range range = range_of(comparison);
  const Scale y = draw_value_axis(svg, frame, range.low, range.high, comparison.question.unit);
  const int last = last_trial(comparison);
  const Scale x{1.0, static_cast<double>(last), frame.left + 16.0,
                kCurveWidth - frame.right - 10.0};
  const int step = std::max(1, last / 10);
  for (int n = 1; n <= last; n += step) {
    svg.text({x(n), kCurveHeight - frame.bottom + 20.0}, std::to_string(n), Anchor::middle,
             colour::kText3, "ax");
  }
  svg.text({kCurveWidth - frame.right + 12.0, kCurveHeight - frame.bottom + 20.0}, "trial",
           Anchor::start, colour::kText3, "ax");

  std::vector<EndLabel> labels;
  std::size_t index = 0;
  for (const ParticipantResult& person : comparison.participants) {
    if (person.group != group.group) continue;
    const Look look = experts ? expert_look(index) : novice_look(index);
    ++index;
    std::vector<Point> points;
    for (std::size_t i = 0; i < person.values.size(); ++i) {
      points.push_back({x(person.trials[i]), y(person.values[i])});
    }
    draw_series(svg, points, look);
    if (!points.empty()) {
      labels.push_back(
          {points.back().y, person.participant, look.colour, look.css_class + " label", true});
    }
  }
  draw_end_labels(svg, kCurveWidth - frame.right + 6.0, labels, frame.top,
                  kCurveHeight - frame.bottom);
  made.svg = svg.finish();
  return made;
}

// Two rows: every trial as a tick, every person's mean as a marker, the group's mean as a line.
Chart participant_means(const GroupComparison& comparison) {
  Chart made{"participant-means",
             "Participant means",
             "",
             "",
             {{"Person", "Group", "Mean, " + comparison.question.unit, "Trials"}, {}}};
  made.summary = "Experts " + plain(comparison.first.over_participants.mean) + ", novices " +
                 plain(comparison.second.over_participants.mean) + " " + comparison.question.unit +
                 ". Marker: mean of one person. Line: group mean. Ticks: single trials.";
  Svg svg("compare-" + made.id, 592.0, 170.0, made.title, made.summary);
  const Range range = range_of(comparison);
  const std::vector<double> ticks = round_ticks(range.low, range.high, 5);
  const Scale x{ticks.front(), ticks.back(), 110.0, 560.0};
  for (const double tick : ticks) {
    svg.line({x(tick), 6.0}, {x(tick), 136.0}, {colour::kGrid, 1.0, "", "grid"});
    svg.text({x(tick), 156.0},
             tick == ticks.back() ? plain(tick) + " " + comparison.question.unit : plain(tick),
             Anchor::middle, colour::kText3, "ax");
  }
  const auto draw_row = [&](const GroupResult& group, double top, bool experts) {
    const Look base = experts ? expert_look(0) : novice_look(0);
    svg.text({2.0, top + 18.0}, experts ? "Experts" : "Novices", Anchor::start, base.colour,
             base.css_class + " label", true);
    svg.text({2.0, top + 34.0}, plural(group.participants, "person", "people"), Anchor::start,
             colour::kText2, "lab2");
    const double mean = x(group.over_participants.mean);
    svg.line({mean, top + 2.0}, {mean, top + 36.0}, {base.colour, 2.0, "", base.css_class});
    svg.text({mean + 6.0, top + 10.0},
             plain(group.over_participants.mean) + " " + comparison.question.unit, Anchor::start,
             base.colour, base.css_class + " label", true);
    std::size_t index = 0;
    for (const ParticipantResult& person : comparison.participants) {
      if (person.group != group.group) continue;
      Look look = base;
      look.index = index++;
      for (const double value : person.values) {
        svg.line({x(value), top + 42.0}, {x(value), top + 49.0},
                 {look.colour, 1.0, "", look.css_class});
      }
      draw_marker(svg, {x(person.summary.mean), top + 26.0}, look, 5.0);
      made.table.rows.push_back({person.participant, group.group, plain(person.summary.mean),
                                 std::to_string(person.summary.count)});
    }
  };
  draw_row(comparison.first, 8.0, true);
  draw_row(comparison.second, 76.0, false);
  made.svg = svg.finish();
  return made;
}

Chart effect_chart(const GroupComparison& comparison) {
  Chart made{"effect",
             "Effect",
             "No effect size can be computed from these data.",
             "",
             {{"Quantity", "Value"}, {}}};
  if (!comparison.effect) {
    Svg svg("compare-effect", 270.0, 100.0, made.title, made.summary);
    svg.text({135.0, 50.0}, "Not computable", Anchor::middle, colour::kText2, "lab2");
    made.svg = svg.finish();
    return made;
  }
  const assessment::HedgesG& effect = *comparison.effect;
  const double low = effect.interval ? effect.interval->low : effect.g;
  const double high = effect.interval ? effect.interval->high : effect.g;
  made.summary =
      "Hedges g " + fixed(effect.g, 2) + ", expert minus novice" +
      (effect.interval ? "; 95 % interval " + fixed(low, 2) + " to " + fixed(high, 2) : "") + ".";
  made.table.rows = {{"Hedges g", fixed(effect.g, 2)}};
  if (effect.interval) {
    made.table.rows.push_back({"95 % interval, low", fixed(low, 2)});
    made.table.rows.push_back({"95 % interval, high", fixed(high, 2)});
  }

  Svg svg("compare-effect", 270.0, 100.0, made.title, made.summary);
  const std::vector<double> ticks = round_ticks(std::min(low, 0.0), std::max(high, 0.0), 4);
  const Scale x{ticks.front(), ticks.back(), 16.0, 254.0};
  svg.line({16.0, 62.0}, {254.0, 62.0}, {colour::kAxis, 1.0, "", "axis"});
  for (const double tick : ticks) {
    svg.line({x(tick), 62.0}, {x(tick), 66.0}, {colour::kAxis, 1.0, "", "axis"});
    svg.text({x(tick), 80.0}, plain(tick), Anchor::middle, colour::kText3, "ax");
  }
  svg.line({x(0.0), 16.0}, {x(0.0), 62.0}, {colour::kText, 1.25, "2 3", "target"});
  svg.text({x(0.0), 96.0}, "no difference", x(0.0) > 135.0 ? Anchor::end : Anchor::start,
           colour::kText2, "lab2");
  if (effect.interval) {
    svg.line({x(low), 38.0}, {x(high), 38.0}, {colour::kText, 2.0, "", "series-you"});
    for (const double end : {low, high}) {
      svg.line({x(end), 32.0}, {x(end), 44.0}, {colour::kText, 2.0, "", "series-you"});
      svg.text({x(end), 24.0}, fixed(end, 2), Anchor::middle, colour::kText2, "lab2");
    }
  }
  Look look = own_look();
  look.index = 2;
  draw_marker(svg, {x(effect.g), 38.0}, look, 5.0);
  made.svg = svg.finish();
  return made;
}

// The smallest p that studies of a few sizes can reach, this one's marked.
Chart p_floor_chart(const GroupComparison& comparison) {
  const int n1 = comparison.ranks.first_count;
  const int n2 = comparison.ranks.second_count;
  Chart made{"p-floor", "p with its floor", "", "", {{"People", "Smallest p"}, {}}};
  const double u = std::min(comparison.ranks.u_first, comparison.ranks.u_second);
  made.summary = "Mann-Whitney U = " + plain(u) + ", p = " + p_text(comparison.ranks.p_two_sided) +
                 (comparison.ranks.exact ? ", exact" : ", asymptotic") + ", two-sided; " +
                 std::to_string(n1) + " against " + std::to_string(n2) +
                 " people can reach no p below " + p_text(comparison.ranks.p_floor) + ".";
  Svg svg("compare-p-floor", 270.0, 100.0, made.title, made.summary);
  const auto place = [](double p) {  // log scale, 0.2 at the left, 0.0005 at the right
    const double t = (std::log10(0.2) - std::log10(p)) / (std::log10(0.2) - std::log10(0.0005));
    return 20.0 + 230.0 * std::clamp(t, 0.0, 1.0);
  };
  svg.line({16.0, 56.0}, {254.0, 56.0}, {colour::kAxis, 1.0, "", "axis"});
  for (const double tick : {0.1, 0.05, 0.01, 0.001}) {
    svg.line({place(tick), 56.0}, {place(tick), 60.0}, {colour::kAxis, 1.0, "", "axis"});
    svg.text({place(tick), 74.0}, p_text(tick), Anchor::middle, colour::kText3, "ax");
  }
  svg.line({place(0.05), 10.0}, {place(0.05), 56.0}, {colour::kText, 1.25, "2 3", "target"});
  std::vector<std::pair<int, int>> sizes = {{n1, n2}};
  for (int n = std::max(n1, n2) + 1; n <= std::max(n1, n2) + 3; ++n) sizes.emplace_back(n, n);
  double free_from = -100.0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const auto [a, b] = sizes[i];
    const double p = assessment::smallest_rank_p(a, b);
    made.table.rows.push_back({std::to_string(a) + " against " + std::to_string(b), p_text(p)});
    Look look = own_look();
    look.index = 3;
    look.filled = i == 0;
    draw_marker(svg, {place(p), 42.0}, look, 5.0);
    if (place(p) < free_from) continue;
    svg.text({place(p), 24.0}, std::to_string(a) + " v " + std::to_string(b), Anchor::middle,
             i == 0 ? colour::kText : colour::kText2, i == 0 ? "lab" : "lab2", i == 0);
    free_from = place(p) + 36.0;
  }
  svg.text({16.0, 94.0}, "smallest p a study of that size can reach", Anchor::start, colour::kText2,
           "lab2");
  made.svg = svg.finish();
  return made;
}

}  // namespace

std::vector<Chart> comparison_charts(const GroupComparison& comparison, const ComparisonSubject&) {
  return {group_curves(comparison, comparison.first, true),
          group_curves(comparison, comparison.second, false), participant_means(comparison),
          effect_chart(comparison), p_floor_chart(comparison)};
}

std::string comparison_headline(const GroupComparison& comparison) {
  const double expert = comparison.first.over_participants.mean;
  const double novice = comparison.second.over_participants.mean;
  const std::string& unit = comparison.question.unit;
  std::string text = expert < novice
                         ? "Experts were faster: "
                         : (expert > novice ? "Experts were slower: " : "No difference: ");
  text += plain(expert) + " " + unit + " against " + plain(novice) + " " + unit + " on average";
  if (comparison.difference) {
    const assessment::MeanDifference& d = *comparison.difference;
    text += ", " + plain(std::abs(d.difference)) + " " + unit +
            (d.difference < 0.0 ? " less" : " more") + " (95 % Welch interval " +
            plain(std::min(std::abs(d.interval.low), std::abs(d.interval.high))) + " to " +
            plain(std::max(std::abs(d.interval.low), std::abs(d.interval.high))) + " " + unit + ")";
    if ((d.interval.low < 0.0) != (d.interval.high < 0.0)) {
      // the interval holds zero: its ends must keep their signs
      text = text.substr(0, text.find(" (95 %")) + " (95 % Welch interval of the difference " +
             plain(d.interval.low) + " to " + plain(d.interval.high) + " " + unit + ")";
    }
  }
  text += ".";
  if (!comparison.separation.empty()) text += " " + comparison.separation;
  return text;
}

}  // namespace reports
