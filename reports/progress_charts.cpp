#include "reports/progress_charts.h"

#include <algorithm>
#include <cmath>

#include "assessment/number_text.h"
#include "reports/axis.h"
#include "reports/number.h"
#include "reports/series.h"

namespace reports {
namespace {

constexpr double kWidth = 560.0;
constexpr double kHeight = 280.0;
constexpr double kSmallWidth = 220.0, kSmallHeight = 120.0;

struct Range {
  double low, high;
};

Range range_of(const ProgressChart& chart) {
  std::vector<double> values;
  for (const TrialPoint& point : chart.points) values.push_back(point.value);
  for (const auto& extra : {chart.target, chart.expert_low, chart.expert_high}) {
    if (extra) values.push_back(*extra);
  }
  if (chart.points.empty() && chart.target) return {0.0, std::max(1.5 * *chart.target, 1e-6)};
  if (values.empty()) return {0.0, 1.0};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double margin = std::max(0.05 * (*high - *low), 0.02 * *high);
  return {std::max(0.0, *low - margin), *high + margin};
}

// A value in words: where there is a target, on the same side of it as the number itself.
std::string value_text(const ProgressChart& chart, double value) {
  return chart.target ? assessment::text_beside(value, *chart.target, chart.unit)
                      : assessment::rounded_text(value, chart.unit);
}

std::string with_unit(const ProgressChart& chart, const std::string& number) {
  return chart.unit.empty() ? number : number + " " + chart.unit;
}

std::string target_text(const ProgressChart& chart) {
  return with_unit(chart, assessment::exact_text(*chart.target));
}

bool is_better(const ProgressChart& chart, double value, double than) {
  return chart.direction == assessment::Direction::lower_is_better ? value < than : value > than;
}

// Of the trials that count; null when none does.
const TrialPoint* best_of(const ProgressChart& chart) {
  const TrialPoint* best = nullptr;
  for (const TrialPoint& point : chart.points) {
    if (point.counted && (best == nullptr || is_better(chart, point.value, best->value))) {
      best = &point;
    }
  }
  return best;
}

// Where that is not the last one, which has a label already.
const TrialPoint* earlier_best(const ProgressChart& chart) {
  const TrialPoint* best = best_of(chart);
  return best == nullptr || best == &chart.points.back() ? nullptr : best;
}

std::string counted(int count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

// What stands in place of a curve.
std::string nothing_text(const ProgressChart& chart) {
  return chart.unfinished == 0 ? "No trial yet" : "No trial completed yet";
}

std::string summary_of(const ProgressChart& chart) {
  const std::string without_curve =
      chart.unfinished == 0
          ? std::string()
          : " " + counted(chart.unfinished, "trial was", "trials were") + " not completed.";
  if (chart.points.empty()) {
    return chart.unfinished == 0 ? "No trial recorded yet."
                                 : "No trial completed yet." + without_curve;
  }
  std::string text = std::to_string(chart.points.size()) +
                     (chart.points.size() == 1 ? " trial: " : " trials, first ") +
                     with_unit(chart, value_text(chart, chart.points.front().value));
  if (chart.points.size() > 1) {
    text += ", last " + with_unit(chart, value_text(chart, chart.points.back().value));
    if (const TrialPoint* best = best_of(chart)) {
      const bool lower = chart.direction == assessment::Direction::lower_is_better;
      text += std::string(", ") + (lower ? "lowest " : "highest ") +
              with_unit(chart, value_text(chart, best->value)) + " in trial " +
              std::to_string(best->ordinal);
    }
  }
  if (chart.target) text += "; target " + target_text(chart);
  if (chart.expert_low && chart.expert_high) {
    text += "; middle half of the experts " + value_text(chart, *chart.expert_low) + " to " +
            with_unit(chart, value_text(chart, *chart.expert_high));
  }
  return text + "." + without_curve;
}

Table table_of(const ProgressChart& chart) {
  Table table;
  table.columns = {"Trial", chart.title + (chart.unit.empty() ? "" : ", " + chart.unit), "Result",
                   "Counts"};
  for (const TrialPoint& point : chart.points) {
    table.rows.push_back({std::to_string(point.ordinal), value_text(chart, point.value),
                          point.passed ? "Passed" : "Not passed", point.counted ? "Yes" : "No"});
  }
  return table;
}

int last_ordinal(const ProgressChart& chart) {
  return std::max(chart.last_ordinal, chart.points.empty() ? 1 : chart.points.back().ordinal);
}

void draw_trial_axis(Svg& svg, const Frame& frame, const Scale& x, int last) {
  const int step =
      last <= 12 ? 1 : (last <= 30 ? 5 : (last <= 120 ? 10 : std::max(20, last / 100 * 10)));
  for (int n = 1; n <= last; ++n) {
    if (n != 1 && n != last && n % step != 0) continue;
    if (n != last && last - n < (step + 1) / 2) continue;
    svg.text({x(n), svg.height() - frame.bottom + 20.0}, std::to_string(n), Anchor::middle,
             colour::kText3, "ax");
  }
  svg.text({svg.width() - frame.right + 16.0, svg.height() - frame.bottom + 20.0}, "trial",
           Anchor::start, colour::kText3, "ax");
}

// The experts' middle half with its median, and the target.
void draw_references(Svg& svg, const Frame& frame, const ProgressChart& chart, const Scale& y,
                     std::vector<EndLabel>& labels) {
  const double left = frame.left;
  const double right = svg.width() - frame.right;
  if (chart.expert_low && chart.expert_high && chart.expert_median) {
    svg.rectangle({left, y(*chart.expert_high)}, right - left,
                  y(*chart.expert_low) - y(*chart.expert_high), colour::kExpertBand, "band-expert");
    svg.line({left, y(*chart.expert_median)}, {right, y(*chart.expert_median)},
             {colour::kExpert, 1.5, "", "series-expert"});
    labels.push_back(
        {y(*chart.expert_median), "Experts, middle half", colour::kExpert, "label-expert"});
  }
  if (chart.target) {
    svg.line({left, y(*chart.target)}, {right, y(*chart.target)},
             {colour::kText, 1.25, "6 4", "target"});
    labels.push_back(
        {y(*chart.target), "Target " + target_text(chart), colour::kText, "label-target"});
  }
}

// A line through all trials; those that do not count are hollow.
void draw_points(Svg& svg, const ProgressChart& chart, const Scale& x, const Scale& y,
                 double size) {
  std::vector<Point> places;
  for (const TrialPoint& point : chart.points) places.push_back({x(point.ordinal), y(point.value)});
  Look look = own_look();
  svg.polyline(places, {look.colour, 1.5, "", look.css_class});
  for (std::size_t i = 0; i < places.size(); ++i) {
    look.filled = chart.points[i].counted;
    draw_marker(svg, places[i], look, size);
  }
}

}  // namespace

Chart progress_chart(const ProgressChart& chart) {
  Chart made{chart.id, chart.title, summary_of(chart), "", table_of(chart)};
  Svg svg(chart.id, kWidth, kHeight, chart.title, made.summary);
  Frame frame;
  frame.right = 150.0;
  const Range range = range_of(chart);
  const Scale y = draw_value_axis(svg, frame, range.low, range.high, chart.unit);
  const int last = last_ordinal(chart);
  const Scale x{1.0, std::max(2.0, static_cast<double>(last)), frame.left + 14.0,
                kWidth - frame.right - 14.0};
  draw_trial_axis(svg, frame, x, last);

  std::vector<EndLabel> labels;
  draw_references(svg, frame, chart, y, labels);
  if (chart.points.empty()) {
    // a quarter from the top, where no target and no band is drawn while there is no trial
    svg.text({(frame.left + kWidth - frame.right) / 2.0, kHeight / 4.0}, nothing_text(chart),
             Anchor::middle, colour::kText2, "lab2");
  } else {
    draw_points(svg, chart, x, y, chart.points.size() > 60 ? 2.0 : 4.0);
    if (const TrialPoint* best = earlier_best(chart)) {
      svg.text({x(best->ordinal), y(best->value) + 17.0}, "best", Anchor::middle, colour::kText2,
               "lab2");
    }
    const std::string value = ", " + with_unit(chart, value_text(chart, chart.points.back().value));
    const double room = frame.right - 14.0 - text_width(value, true);
    labels.push_back({y(chart.points.back().value), shortened(chart.who, room, true, true) + value,
                      own_look().colour, "label-you"});
  }
  draw_end_labels(svg, kWidth - frame.right + 8.0, labels, frame.top, kHeight - frame.bottom);
  made.svg = svg.finish();
  return made;
}

Chart small_progress_chart(const ProgressChart& chart) {
  Chart made{chart.id, chart.title, summary_of(chart), "", table_of(chart)};
  Svg svg(chart.id, kSmallWidth, kSmallHeight, chart.title, made.summary);
  const Frame frame{42.0, 54.0, 10.0, 26.0};
  const double left = frame.left, right = kSmallWidth - frame.right;
  const double bottom = kSmallHeight - frame.bottom;

  const Range range = range_of(chart);
  const std::vector<double> ticks = round_ticks(range.low, range.high, 2);
  const std::vector<std::string> words = tick_texts(ticks);
  const Scale y{ticks.front(), ticks.back(), bottom, frame.top};
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    svg.line({left, y(ticks[i])}, {right, y(ticks[i])}, {colour::kGrid, 1.0, "", "grid"});
    svg.text({left - 5.0, y(ticks[i]) + 4.0}, words[i], Anchor::end, colour::kText3, "ax");
  }
  const int last = last_ordinal(chart);
  const Scale x{1.0, std::max(2.0, static_cast<double>(last)), left + 6.0, right - 6.0};
  const double foot = kSmallHeight - 8.0;
  svg.text({x(1.0), foot}, "1", Anchor::middle, colour::kText3, "ax");
  if (last > 1) {
    svg.text({x(last), foot}, std::to_string(last), Anchor::middle, colour::kText3, "ax");
  }
  svg.text({(left + right) / 2.0, foot}, "trial", Anchor::middle, colour::kText3, "ax");

  std::vector<EndLabel> labels;
  if (chart.expert_low && chart.expert_high && chart.expert_median) {
    svg.rectangle({left, y(*chart.expert_high)}, right - left,
                  y(*chart.expert_low) - y(*chart.expert_high), colour::kExpertBand, "band-expert");
    svg.line({left, y(*chart.expert_median)}, {right, y(*chart.expert_median)},
             {colour::kExpert, 1.5, "", "series-expert"});
    labels.push_back({y(*chart.expert_median), "experts", colour::kExpert, "label-expert"});
  }
  if (chart.target) {
    svg.line({left, y(*chart.target)}, {right, y(*chart.target)},
             {colour::kText, 1.25, "6 4", "target"});
    labels.push_back({y(*chart.target), "target", colour::kText, "label-target"});
  }
  if (chart.points.empty()) {
    svg.text({(left + right) / 2.0, kSmallHeight / 4.0},
             chart.unfinished == 0 ? "No trial yet" : "None completed", Anchor::middle,
             colour::kText2, "lab2");
  } else {
    draw_points(svg, chart, x, y, chart.points.size() > 20 ? 1.75 : 3.0);
    const double value = chart.points.back().value;
    labels.push_back({y(value), value_text(chart, value), own_look().colour, "label-you"});
  }
  draw_end_labels(svg, right + 6.0, labels, frame.top, bottom);
  made.svg = svg.finish();
  return made;
}

std::string progress_headline(const std::string& exercise_title, const ProgressChart& chart,
                              const std::string& proficiency, bool you) {
  std::vector<double> values;  // of the trials that count
  for (const TrialPoint& point : chart.points) {
    if (point.counted) values.push_back(point.value);
  }
  if (values.empty()) {
    const int trials = chart.unfinished + static_cast<int>(chart.points.size());
    if (trials == 0) return exercise_title + ": no trial yet.";
    const char* why = chart.points.empty() ? "none completed" : "none of them counts";
    return exercise_title + ": " + counted(trials, "trial", "trials") + ", " + why + "; " +
           proficiency + ".";
  }
  const std::size_t count = std::min<std::size_t>(3, values.size());
  std::string text =
      exercise_title + ": " +
      (count == 1 ? "last trial "
                  : "last " + std::string(count == 2 ? "two" : "three") + " trials ");
  for (std::size_t i = values.size() - count; i < values.size(); ++i) {
    if (i > values.size() - count) text += ", ";
    text += value_text(chart, values[i]);
  }
  text = with_unit(chart, text);
  if (chart.target) {
    text += "; target " + target_text(chart) + (chart.target_provisional ? " (provisional)" : "");
  }
  const double first = values.front();
  const double last = values.back();
  if (values.size() > 1 && first > 0.0) {
    const double percent = 100.0 * (first - last) / first;
    const bool time = chart.unit == "s";
    const char* less = time ? "faster" : "lower";
    const char* more = time ? "slower" : "higher";
    const std::string whose = you ? "your first" : "the first";
    if (fixed(percent, 0) == "0") {
      text += (time ? "; as fast as " : "; the same as ") + whose;
    } else {
      text += "; " + fixed(std::abs(percent), 0) + " % " + (percent > 0.0 ? less : more) +
              " than " + whose;
    }
  }
  return text + "; " + proficiency + ".";
}

}  // namespace reports
