// The effect with its interval, and p with its floor.
#include <algorithm>
#include <cmath>
#include <utility>

#include "assessment/statistics/rank_test.h"
#include "reports/axis.h"
#include "reports/comparison_parts.h"
#include "reports/number.h"
#include "reports/series.h"

namespace reports {
namespace {

using assessment::GroupComparison;

constexpr double kWidth = 290.0;
constexpr double kHeight = 110.0;
constexpr double kLeft = 26.0;
constexpr double kRight = kWidth - 26.0;

Chart no_effect(Chart made) {
  made.summary = "No effect size can be computed from these data.";
  Svg svg("compare-effect", kWidth, kHeight, made.title, made.summary);
  svg.text({kWidth / 2.0, kHeight / 2.0}, "Not computable", Anchor::middle, colour::kText2, "lab2");
  made.svg = svg.finish();
  return made;
}

// The numbers above the interval: g itself only where it has room between the ends.
void draw_effect_labels(Svg& svg, const assessment::HedgesG& effect, const Scale& x) {
  const double middle = x(effect.g);
  double left = middle - 1e3, right = middle + 1e3;
  if (effect.interval) {
    left = x(effect.interval->low);
    right = x(effect.interval->high);
    const bool tight = right - left < 44.0;
    svg.text({left + (tight ? 4.0 : 0.0), 20.0}, fixed(effect.interval->low, 2),
             tight || left > kRight - 20.0 ? Anchor::end : Anchor::middle, colour::kText2, "lab2");
    svg.text({right - (tight ? 4.0 : 0.0), 20.0}, fixed(effect.interval->high, 2),
             tight || right < kLeft + 20.0 ? Anchor::start : Anchor::middle, colour::kText2,
             "lab2");
  }
  if (middle - left >= 42.0 && right - middle >= 42.0) {
    svg.text({middle, 20.0}, fixed(effect.g, 2), Anchor::middle, colour::kText, "lab", true);
  }
}

// Which side of zero favours whom, in the words of the data's own direction.
void draw_effect_sides(Svg& svg, const GroupComparison& comparison, const Scale& x) {
  const double zero = x(0.0);
  const double g = comparison.effect->g;
  const bool lower_is_better =
      comparison.question.direction == assessment::Direction::lower_is_better;
  const std::string better =
      comparison.question.unit == "s" && lower_is_better ? "faster" : "better";
  const bool zero_right = zero > kWidth / 2.0;
  svg.text({std::clamp(zero, kLeft, kRight), 102.0}, "no difference",
           zero_right ? Anchor::end : Anchor::start, colour::kText2, "lab2");
  const double room = zero_right ? zero - 84.0 - kLeft : kRight - zero - 84.0;
  const std::string who = ((g < 0.0) == lower_is_better ? "experts " : "novices ") + better;
  if (g == 0.0 || zero_right != (g < 0.0) || room < text_width(who)) return;
  svg.text({zero_right ? kLeft - 10.0 : kRight + 10.0, 102.0}, who,
           zero_right ? Anchor::start : Anchor::end, colour::kText2, "lab2");
}

// A logarithmic axis from the largest to the smallest p shown.
struct PAxis {
  double low_log, high_log;  // of the smallest and the largest p
  double operator()(double p) const {
    return kLeft + (high_log - std::log10(p)) / (high_log - low_log) * (kRight - kLeft);
  }
};

// Powers of ten, as many as have room, and 0.05, which the dotted line marks.
void draw_p_ticks(Svg& svg, const PAxis& axis) {
  svg.line({kLeft - 10.0, 60.0}, {kRight + 10.0, 60.0}, {colour::kAxis, 1.0, "", "axis"});
  svg.line({axis(0.05), 8.0}, {axis(0.05), 60.0}, {colour::kText, 1.25, "2 3", "target"});
  const auto tick = [&](double p, const std::string& words, Anchor anchor) {
    svg.line({axis(p), 60.0}, {axis(p), 64.0}, {colour::kAxis, 1.0, "", "axis"});
    svg.text({axis(p), 79.0}, words, anchor, colour::kText3, "ax");
  };
  const bool narrow = axis(0.05) - axis(0.1) < 34.0;
  tick(0.05, "0.05", narrow ? Anchor::start : Anchor::middle);
  const int first = static_cast<int>(std::floor(axis.high_log));
  const int last = static_cast<int>(std::ceil(axis.low_log));
  const int stride = std::max(1, (first - last + 3) / 4);
  for (int exponent = first; exponent >= last; exponent -= stride) {
    const double p = std::pow(10.0, exponent);
    if (p < 0.05 && axis(p) - axis(0.05) < (narrow ? 46.0 : 34.0)) continue;
    if (p > 0.05 && axis(0.05) - axis(p) < 14.0) continue;
    tick(p, exponent == -1 ? "0.10" : power_of_ten_text(exponent),
         narrow && exponent == -1 ? Anchor::end : Anchor::middle);
  }
}

}  // namespace

Chart effect_chart(const GroupComparison& comparison) {
  Chart made;
  made.id = "effect";
  made.title = "Effect";
  made.table.columns = {"Quantity", "Value"};
  if (!comparison.effect) return no_effect(std::move(made));
  const assessment::HedgesG& effect = *comparison.effect;
  const double low = effect.interval ? effect.interval->low : effect.g;
  const double high = effect.interval ? effect.interval->high : effect.g;
  made.summary = "Hedges g " + fixed(effect.g, 2) + ", expert minus novice";
  made.table.rows = {{"Hedges g", fixed(effect.g, 2)}};
  if (effect.interval) {
    const std::string name = fixed(effect.interval->confidence * 100.0, 0) + " % interval";
    made.summary += "; " + name + " " + fixed(low, 2) + " to " + fixed(high, 2);
    made.table.rows.push_back({name + ", low", fixed(low, 2)});
    made.table.rows.push_back({name + ", high", fixed(high, 2)});
  }
  made.summary += ".";

  Svg svg("compare-effect", kWidth, kHeight, made.title, made.summary);
  const std::vector<double> ticks = round_ticks(std::min(low, 0.0), std::max(high, 0.0), 4);
  const std::vector<std::string> words = tick_texts(ticks);
  const Scale x{ticks.front(), ticks.back(), kLeft, kRight};
  svg.line({kLeft - 10.0, 62.0}, {kRight + 10.0, 62.0}, {colour::kAxis, 1.0, "", "axis"});
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    svg.line({x(ticks[i]), 62.0}, {x(ticks[i]), 66.0}, {colour::kAxis, 1.0, "", "axis"});
    svg.text({x(ticks[i]), 81.0}, words[i], Anchor::middle, colour::kText3, "ax");
  }
  // below the numbers, which may stand beside it
  svg.line({x(0.0), 26.0}, {x(0.0), 62.0}, {colour::kText, 1.25, "2 3", "target"});
  if (effect.interval) {
    svg.line({x(low), 40.0}, {x(high), 40.0}, {colour::kText, 2.0, "", "series-you"});
    for (const double end : {low, high}) {
      svg.line({x(end), 34.0}, {x(end), 46.0}, {colour::kText, 2.0, "", "series-you"});
    }
  }
  draw_effect_labels(svg, effect, x);
  draw_effect_sides(svg, comparison, x);
  Look look = own_look();
  look.index = 2;
  draw_marker(svg, {x(effect.g), 40.0}, look, 5.0);
  made.svg = svg.finish();
  return made;
}

// The smallest p that studies of a few sizes can reach, this one's marked.
Chart p_floor_chart(const GroupComparison& comparison) {
  const int n1 = comparison.ranks.first_count;
  const int n2 = comparison.ranks.second_count;
  Chart made;
  made.id = "p-floor";
  made.title = "p with its floor";
  made.table.columns = {"People", "Smallest p"};
  const double u = std::min(comparison.ranks.u_first, comparison.ranks.u_second);
  made.summary = "Mann-Whitney U = " + fixed(u, common_decimals({u}, 1)) + ", " +
                 p_statement(comparison.ranks.p_two_sided) +
                 (comparison.ranks.exact ? ", exact" : ", asymptotic") + ", two-sided; " +
                 std::to_string(n1) + " against " + std::to_string(n2) +
                 " people can reach no p below " + small_text(comparison.ranks.p_floor) + ".";

  std::vector<std::pair<int, int>> sizes = {{n1, n2}};
  for (int n = std::max(n1, n2) + 1; n <= std::max(n1, n2) + 3; ++n) sizes.emplace_back(n, n);
  std::vector<double> floors;
  for (const auto& [a, b] : sizes) {
    floors.push_back(assessment::smallest_rank_p(a, b));
    made.table.rows.push_back(
        {std::to_string(a) + " against " + std::to_string(b), small_text(floors.back())});
  }
  Svg svg("compare-p-floor", kWidth, kHeight, made.title, made.summary);
  const auto [least, most] = std::minmax_element(floors.begin(), floors.end());
  const PAxis axis{std::log10(std::min(*least, 0.001)), std::log10(std::max(*most, 0.2))};
  draw_p_ticks(svg, axis);
  double free_from = -100.0;
  for (std::size_t i = sizes.size(); i-- > 0;) {  // this study last, on top
    Look look = own_look();
    look.index = 3;
    look.filled = i == 0;
    draw_marker(svg, {axis(floors[i]), 44.0}, look, 5.0);
  }
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const std::string words =
        std::to_string(sizes[i].first) + " v " + std::to_string(sizes[i].second);
    const double half = text_width(words, i == 0) / 2.0;
    const double place = std::clamp(axis(floors[i]), half, kWidth - half);
    if (place - half < free_from) continue;
    svg.text({place, 24.0}, words, Anchor::middle, i == 0 ? colour::kText : colour::kText2,
             i == 0 ? "lab" : "lab2", i == 0);
    free_from = place + half + 2.0;
  }
  svg.text({kLeft - 10.0, 102.0}, "smallest p a study of that size can reach", Anchor::start,
           colour::kText2, "lab2");
  made.svg = svg.finish();
  return made;
}

}  // namespace reports
