#include "reports/trial_charts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "assessment/number_text.h"
#include "reports/axis.h"
#include "reports/number.h"
#include "reports/series.h"

namespace reports {
namespace {

constexpr double kStepWidth = 560.0;
constexpr std::size_t kListed = 6;  // steps the sentence names one by one
constexpr double kTimelineWidth = 880.0;
constexpr double kTimelineHeight = 260.0;
constexpr int kBins = 420;            // columns the force curve is thinned to; each keeps its peak
constexpr std::size_t kLettered = 3;  // wall hits that get a letter

std::string clock_text(double seconds) {
  char text[32];
  const int whole = static_cast<int>(std::lround(seconds));
  std::snprintf(text, sizeof text, "%d:%02d", whole / 60, whole % 60);
  return text;
}

// The force curve: the largest value of each column, so that no peak is lost.
std::vector<Point> thinned(const assessment::RecordedTrial& trial, const Scale& x, const Scale& y) {
  std::vector<Point> points;
  const std::size_t count = trial.samples.size();
  const std::size_t per_bin = std::max<std::size_t>(1, count / kBins);
  for (std::size_t begin = 0; begin < count; begin += per_bin) {
    const std::size_t end = std::min(count, begin + per_bin);
    const auto peak = std::max_element(
        trial.samples.begin() + static_cast<std::ptrdiff_t>(begin),
        trial.samples.begin() + static_cast<std::ptrdiff_t>(end),
        [](const auto& a, const auto& b) { return a.contact_force_peak < b.contact_force_peak; });
    points.push_back({x(peak->time), y(peak->contact_force_peak)});
  }
  return points;
}

struct Peak {
  double time = 0.0;   // s
  double force = 0.0;  // N
};

Peak peak_within(const assessment::RecordedTrial& trial, double from, double until) {
  Peak peak{from, 0.0};
  for (const assessment::Sample& sample : trial.samples) {
    if (sample.time >= from && sample.time < until && sample.contact_force_peak > peak.force) {
      peak = {sample.time, sample.contact_force_peak};
    }
  }
  return peak;
}

struct Hit {
  double time = 0.0;
  Peak peak;  // until the next hit or for two seconds
};

// The hardest wall hits in the order of time.
std::vector<Hit> hardest_hits(const assessment::RecordedTrial& trial) {
  std::vector<Hit> hits;
  for (const assessment::Event& event : trial.events) {
    if (event.code == "wall_hit") hits.push_back({event.time, {}});
  }
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const double until = i + 1 < hits.size() ? hits[i + 1].time : hits[i].time + 2.0;
    hits[i].peak = peak_within(trial, hits[i].time, std::min(until, hits[i].time + 2.0));
  }
  std::sort(hits.begin(), hits.end(),
            [](const Hit& a, const Hit& b) { return a.peak.force > b.peak.force; });
  if (hits.size() > kLettered) hits.resize(kLettered);
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.time < b.time; });
  return hits;
}

void draw_letter(Svg& svg, Point at, char letter) {
  svg.rectangle({at.x - 8.0, at.y - 22.0}, 16.0, 16.0, colour::kText, "event-tag", 3.0);
  svg.text({at.x, at.y - 10.0}, std::string(1, letter), Anchor::middle, colour::kSurface,
           "event-letter", true);
}

void draw_time_axis(Svg& svg, const Frame& frame, const Scale& x, double end) {
  const double steps[] = {1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800};
  double step = 3600.0;
  for (const double candidate : steps) {
    if (end / candidate <= 9.0) {
      step = candidate;
      break;
    }
  }
  for (double t = 0.0; t <= end + 1e-9; t += step) {
    svg.text({x(t), svg.height() - frame.bottom + 20.0}, clock_text(t), Anchor::middle,
             colour::kText3, "ax");
  }
}

// A thin line where each step begins, with its name where there is room.
void draw_steps(Svg& svg, const Frame& frame, const assessment::RecordedTrial& trial,
                const Scale& x) {
  double free_from = 0.0;
  for (const assessment::TrialStep& step : trial.steps) {
    if (!step.done() && step.started <= 0.0 && &step != &trial.steps.front()) continue;
    const double place = x(step.started);
    svg.line({place, frame.top - 4.0}, {place, svg.height() - frame.bottom},
             {colour::kAxis, 1.0, "2 3", "axis"});
    if (place >= free_from) {
      const std::string words = shortened(step.id, svg.width() - place - 8.0);
      svg.text({place + 4.0, frame.top - 12.0}, words, Anchor::start, colour::kText2, "lab2", false,
               step.id);
      free_from = place + text_width(words) + 12.0;
    }
  }
}

}  // namespace

namespace {

// Two decimals, or as many as it takes to stand on the right side of the limit.
std::string force_text(double newtons, const std::optional<double>& limit_n) {
  const std::string usual = fixed(newtons, 2);
  if (!limit_n) return usual;
  const std::string beside = assessment::text_beside(newtons, *limit_n, "N");
  return beside.size() > usual.size() ? beside : usual;
}

// As wide as the longest title, within bounds that leave room for the bars.
double label_width(const std::vector<StepDuration>& steps) {
  double widest = 0.0;
  for (const StepDuration& step : steps) widest = std::max(widest, text_width(step.title));
  return std::clamp(widest + 16.0, 80.0, 240.0);
}

std::string many_steps_text(const std::vector<StepDuration>& steps) {
  const auto [shortest, longest] =
      std::minmax_element(steps.begin(), steps.end(),
                          [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
  return std::to_string(steps.size()) + " steps; longest: " + longest->title + " " +
         fixed(longest->seconds, 1) + " s, shortest: " + shortest->title + " " +
         fixed(shortest->seconds, 1) + " s";
}

}  // namespace

Chart step_time_chart(const std::vector<StepDuration>& steps) {
  Chart made{"step-times", "Time per step", "", "", {{"Step", "Time, s"}, {}}};
  double longest = 0.0;
  for (const StepDuration& step : steps) {
    longest = std::max(longest, step.seconds);
    made.table.rows.push_back({step.title, fixed(step.seconds, 2)});
    made.summary +=
        (made.summary.empty() ? "" : ", ") + step.title + " " + fixed(step.seconds, 1) + " s";
  }
  if (steps.size() > kListed) made.summary = many_steps_text(steps);
  made.summary = steps.empty() ? "No step was completed." : made.summary + ".";

  const double row = steps.size() > kListed ? 24.0 : 40.0;
  const double height = 40.0 + row * static_cast<double>(std::max<std::size_t>(steps.size(), 2));
  Svg svg(made.id, kStepWidth, height, made.title, made.summary);
  const std::vector<double> ticks = round_ticks(0.0, std::max(longest, 1.0), 4);
  const std::vector<std::string> words = tick_texts(ticks);
  const double left = label_width(steps);
  const Scale x{0.0, ticks.back(), left, kStepWidth - 60.0};
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    svg.line({x(ticks[i]), 8.0}, {x(ticks[i]), height - 28.0}, {colour::kGrid, 1.0, "", "grid"});
    svg.text({x(ticks[i]), height - 10.0}, i + 1 == ticks.size() ? words[i] + " s" : words[i],
             Anchor::middle, colour::kText3, "ax");
  }
  if (steps.empty()) {
    svg.text({kStepWidth / 2.0, height / 2.0}, made.summary, Anchor::middle, colour::kText2,
             "lab2");
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double y = 8.0 + row * (static_cast<double>(i) + 0.5);
    svg.text({left - 12.0, y + 4.0}, shortened(steps[i].title, left - 16.0), Anchor::end,
             colour::kText2, "lab2", false, steps[i].title);
    svg.line({x(0.0), y}, {x(steps[i].seconds), y}, {colour::kText, 3.0, "", "series-you"});
    draw_marker(svg, {x(steps[i].seconds), y}, own_look(), 4.5);
    svg.text({x(steps[i].seconds) + 10.0, y + 4.0}, fixed(steps[i].seconds, 1) + " s",
             Anchor::start, colour::kText, "lab", true);
  }
  made.svg = svg.finish();
  return made;
}

Chart contact_force_chart(const assessment::RecordedTrial& trial, std::optional<double> limit_n) {
  Chart made{
      "contact-force", "Contact force", "", "", {{"Wall hit", "Time, s", "Highest force, N"}, {}}};
  double highest = 0.0;
  for (const assessment::Sample& sample : trial.samples) {
    highest = std::max(highest, sample.contact_force_peak);
  }
  const std::vector<Hit> hits = hardest_hits(trial);
  const auto all_hits = std::count_if(trial.events.begin(), trial.events.end(),
                                      [](const auto& event) { return event.code == "wall_hit"; });
  made.summary =
      "Highest contact force " + force_text(highest, limit_n) + " N" +
      (limit_n ? ", training limit " + assessment::exact_text(*limit_n) + " N" : "") + "; " +
      std::to_string(all_hits) + (all_hits == 1 ? " wall hit" : " wall hits") +
      (all_hits > static_cast<long>(kLettered) ? ", the three hardest are lettered." : ".");

  Svg svg(made.id, kTimelineWidth, kTimelineHeight, made.title, made.summary);
  Frame frame;
  frame.right = 90.0;
  frame.top = 40.0;
  const double top_value = std::max({highest * 1.15, limit_n.value_or(0.0) * 1.05, 0.1});
  const Scale y = draw_value_axis(svg, frame, 0.0, top_value, "N");
  const double end = std::max(trial.end_time, 1.0);
  const Scale x{0.0, end, frame.left, kTimelineWidth - frame.right};
  draw_time_axis(svg, frame, x, end);
  draw_steps(svg, frame, trial, x);
  if (trial.samples.empty()) {
    svg.text({(frame.left + kTimelineWidth - frame.right) / 2.0, kTimelineHeight / 2.0},
             "No force was recorded", Anchor::middle, colour::kText2, "lab2");
  }
  svg.polyline(thinned(trial, x, y), {colour::kText, 1.25, "", "series-you"});
  if (limit_n) {
    svg.line({frame.left, y(*limit_n)}, {kTimelineWidth - frame.right, y(*limit_n)},
             {colour::kLimit, 1.5, "", "limit"});
    svg.text({kTimelineWidth - frame.right + 8.0, y(*limit_n) + 4.0},
             "Limit " + assessment::exact_text(*limit_n) + " N", Anchor::start, colour::kLimit,
             "label-limit", true);
  }
  double free_from = 0.0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const char letter = static_cast<char>('A' + i);
    free_from = std::max(free_from, x(hits[i].peak.time));
    draw_letter(svg, {free_from, std::max(y(hits[i].peak.force), frame.top + 18.0)}, letter);
    free_from += 18.0;  // letters of hits in quick succession stand side by side
    made.table.rows.push_back(
        {std::string(1, letter), fixed(hits[i].time, 2), force_text(hits[i].peak.force, limit_n)});
  }
  made.svg = svg.finish();
  return made;
}

}  // namespace reports
