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

// The lowest of the trials that count, where that is not the last one, which has a label already.
const TrialPoint* earlier_best(const ProgressChart& chart) {
  const TrialPoint* best = nullptr;
  for (const TrialPoint& point : chart.points) {
    if (point.counted && (best == nullptr || point.value < best->value)) best = &point;
  }
  return best == nullptr || best == &chart.points.back() ? nullptr : best;
}

std::string summary_of(const ProgressChart& chart) {
  if (chart.points.empty()) return "No trial recorded yet.";
  std::string text = std::to_string(chart.points.size()) +
                     (chart.points.size() == 1 ? " trial: " : " trials, first ") +
                     with_unit(chart, value_text(chart, chart.points.front().value));
  if (chart.points.size() > 1) {
    const auto best = std::min_element(
        chart.points.begin(), chart.points.end(),
        [](const TrialPoint& a, const TrialPoint& b) { return a.value < b.value; });
    text += ", last " + with_unit(chart, value_text(chart, chart.points.back().value)) +
            ", lowest " + with_unit(chart, value_text(chart, best->value)) + " in trial " +
            std::to_string(best->ordinal);
  }
  if (chart.target) text += "; target " + target_text(chart);
  return text + ".";
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

}  // namespace

Chart progress_chart(const ProgressChart& chart) {
  Chart made{chart.id, chart.title, summary_of(chart), "", table_of(chart)};
  Svg svg(chart.id, kWidth, kHeight, chart.title, made.summary);
  Frame frame;
  frame.right = 150.0;
  const Range range = range_of(chart);
  const Scale y = draw_value_axis(svg, frame, range.low, range.high, chart.unit);
  const int last = chart.points.empty() ? 1 : chart.points.back().ordinal;
  const Scale x{1.0, std::max(2.0, static_cast<double>(last)), frame.left + 14.0,
                kWidth - frame.right - 14.0};
  draw_trial_axis(svg, frame, x, last);

  std::vector<EndLabel> labels;
  draw_references(svg, frame, chart, y, labels);
  if (chart.points.empty()) {
    // a quarter from the top, where no target and no band is drawn while there is no trial
    svg.text({(frame.left + kWidth - frame.right) / 2.0, kHeight / 4.0}, "No trial yet",
             Anchor::middle, colour::kText2, "lab2");
  } else {
    std::vector<Point> places;
    for (const TrialPoint& point : chart.points)
      places.push_back({x(point.ordinal), y(point.value)});
    Look look = own_look();
    svg.polyline(places, {look.colour, 1.5, "", look.css_class});
    for (std::size_t i = 0; i < places.size(); ++i) {
      look.filled = chart.points[i].counted;
      draw_marker(svg, places[i], look, places.size() > 60 ? 2.0 : 4.0);
    }
    if (const TrialPoint* best = earlier_best(chart)) {
      svg.text({x(best->ordinal), y(best->value) + 17.0}, "best", Anchor::middle, colour::kText2,
               "lab2");
    }
    const std::string value = ", " + with_unit(chart, value_text(chart, chart.points.back().value));
    const double room = frame.right - 14.0 - text_width(value, true);
    labels.push_back({places.back().y, shortened(chart.who, room, true, true) + value, look.colour,
                      "label-you"});
  }
  draw_end_labels(svg, kWidth - frame.right + 8.0, labels, frame.top, kHeight - frame.bottom);
  made.svg = svg.finish();
  return made;
}

std::string progress_headline(const std::string& exercise_title, const ProgressChart& chart,
                              const std::string& proficiency, bool you) {
  if (chart.points.empty()) return exercise_title + ": no trial yet.";
  const std::size_t count = std::min<std::size_t>(3, chart.points.size());
  std::string text =
      exercise_title + ": " +
      (count == 1 ? "last trial "
                  : "last " + std::string(count == 2 ? "two" : "three") + " trials ");
  for (std::size_t i = chart.points.size() - count; i < chart.points.size(); ++i) {
    if (i > chart.points.size() - count) text += ", ";
    text += value_text(chart, chart.points[i].value);
  }
  text = with_unit(chart, text);
  if (chart.target) {
    text += "; target " + target_text(chart) + (chart.target_provisional ? " (provisional)" : "");
  }
  const double first = chart.points.front().value;
  const double last = chart.points.back().value;
  if (chart.points.size() > 1 && first > 0.0) {
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
