#include "reports/instrument_charts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reports/axis.h"
#include "reports/number.h"

namespace reports {
namespace {

constexpr double kWidth = 560.0, kHeight = 260.0;  // px
constexpr double kStep = 0.5;                      // mm between points of the line
constexpr double kDegrees = 180.0 / std::numbers::pi;

double curvature_at(const std::vector<TipBend>& bends, double from_tip) {
  double curvature = 0.0;
  for (const TipBend& bend : bends) {
    if (from_tip > bend.from_tip && from_tip < bend.from_tip + bend.length) {
      curvature += bend.angle / bend.length;
    }
  }
  return curvature;
}

double total_length(const std::vector<StiffnessSection>& sections) {
  double sum = 0.0;
  for (const StiffnessSection& section : sections) sum += section.length;
  return sum;
}

Table table_of(const std::vector<StiffnessSection>& sections) {
  Table table;
  table.columns = {"From the tip, mm", "To, mm", "Bending stiffness EI, N mm²",
                   "Twist stiffness GJ, N mm²"};
  double at = 0.0;
  for (const StiffnessSection& section : sections) {
    table.rows.push_back({plain(at), plain(at + section.length), plain(section.bending_stiffness),
                          plain(section.twist_stiffness)});
    at += section.length;
  }
  return table;
}

// A staircase: constant in each section. Position by the square root, so that a short tip shows.
std::vector<Point> staircase(const std::vector<StiffnessSection>& sections,
                             double StiffnessSection::*value, const Scale& x, const Scale& y) {
  std::vector<Point> points;
  double at = 0.0;
  for (const StiffnessSection& section : sections) {
    const double level = y(std::log10(section.*value));
    points.push_back({x(std::sqrt(at)), level});
    at += section.length;
    points.push_back({x(std::sqrt(at)), level});
  }
  return points;
}

// The length of a scale bar that fits: 1, 2 or 5 times a power of ten.
double round_length(double at_most) {
  const double power = std::pow(10.0, std::floor(std::log10(at_most)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= at_most) return factor * power;
  }
  return power;
}

}  // namespace

Chart stiffness_chart(const std::string& id, const std::string& instrument,
                      const std::vector<StiffnessSection>& sections) {
  Chart chart{id, "Stiffness over the length of " + instrument, "", "", table_of(sections)};
  if (sections.empty()) return chart;
  const StiffnessSection &tip = sections.front(), &back = sections.back();
  chart.summary = "Bending stiffness " + plain(tip.bending_stiffness) + " N mm² at the tip and " +
                  plain(back.bending_stiffness) + " N mm² at the back; twist stiffness " +
                  plain(tip.twist_stiffness) + " and " + plain(back.twist_stiffness) + " N mm².";
  Svg svg(id, kWidth, kHeight, chart.title, chart.summary);
  double low = tip.bending_stiffness, high = low;
  for (const StiffnessSection& section : sections) {
    low = std::min({low, section.bending_stiffness, section.twist_stiffness});
    high = std::max({high, section.bending_stiffness, section.twist_stiffness});
  }
  const double left = 64.0, right = kWidth - 130.0, top = 34.0, bottom = kHeight - 44.0;
  const Scale y{std::floor(std::log10(low)), std::floor(std::log10(high)) + 1.0, bottom, top};
  const double length = total_length(sections);
  const Scale x{0.0, std::sqrt(length), left, right};

  for (int power = static_cast<int>(y.low); power <= static_cast<int>(y.high); ++power) {
    svg.line({left, y(power)}, {right, y(power)}, {colour::kGrid, 1.0, "", "grid"});
    svg.text({left - 8.0, y(power) + 4.0}, power_of_ten_text(power), Anchor::end, colour::kText3,
             "ax");
  }
  svg.text({left - 8.0, top - 14.0}, "N mm²", Anchor::end, colour::kText3, "ax");
  double drawn_to = -1e9;
  for (const double at : {0.0, 10.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 1500.0, 2000.0}) {
    if (at > length || x(std::sqrt(at)) < drawn_to + 30.0) continue;
    drawn_to = x(std::sqrt(at));
    svg.line({drawn_to, bottom}, {drawn_to, bottom + 4.0}, {colour::kAxis, 1.0, "", "axis"});
    svg.text({drawn_to, bottom + 18.0}, fixed(at, 0), Anchor::middle, colour::kText3, "ax");
  }
  svg.line({left, bottom}, {right, bottom}, {colour::kAxis, 1.0, "", "axis"});
  svg.text({right, bottom + 36.0}, "mm from the tip (square-root scale)", Anchor::end,
           colour::kText3, "ax");

  const auto bending = staircase(sections, &StiffnessSection::bending_stiffness, x, y);
  const auto twist = staircase(sections, &StiffnessSection::twist_stiffness, x, y);
  svg.polyline(bending, {colour::kExpert, 2.0, "", "series-expert"});
  svg.polyline(twist, {colour::kNovice, 2.0, "6 4", "series-novice"});
  double bending_label = bending.back().y + 4.0, twist_label = twist.back().y + 4.0;
  if (std::abs(bending_label - twist_label) < 15.0) {  // apart, in their order
    const double middle = (bending_label + twist_label) / 2.0;
    const double side = bending_label <= twist_label ? -8.0 : 8.0;
    bending_label = middle + side;
    twist_label = middle - side;
  }
  svg.text({right + 8.0, bending_label}, "EI, bending", Anchor::start, colour::kExpert,
           "label-expert");
  svg.text({right + 8.0, twist_label}, "GJ, twist (dashed)", Anchor::start, colour::kNovice,
           "label-novice");
  chart.svg = svg.finish();
  return chart;
}

std::vector<Point> tip_line(const std::vector<TipBend>& bends, double shown) {
  const int steps = std::max(1, static_cast<int>(std::lround(shown / kStep)));
  const double step = shown / steps;
  std::vector<Point> line{{0.0, 0.0}};
  double heading = 0.0;
  for (int i = 0; i < steps; ++i) {
    // the middle of the step decides; the chord of an arc is exact
    const double turn = curvature_at(bends, shown - (i + 0.5) * step) * step;
    const double half = turn / 2.0;
    const double chord = half == 0.0 ? step : step * std::sin(half) / half;
    const Point last = line.back();
    line.push_back(
        {last.x + chord * std::cos(heading + half), last.y + chord * std::sin(heading + half)});
    heading += turn;
  }
  return line;
}

Chart tip_chart(const std::string& id, const std::string& instrument,
                const std::vector<TipBend>& bends, double outer_diameter) {
  double bent = 0.0, angle = 0.0;
  for (const TipBend& bend : bends) {
    bent = std::max(bent, bend.from_tip + bend.length);
    angle += bend.angle;
  }
  const double shown = std::max(30.0, std::ceil((bent + 10.0) / 10.0) * 10.0);
  Chart chart{id, "Tip of " + instrument + " at rest", "", "", {}};
  chart.summary = bends.empty() ? "The tip is straight."
                                : "The tip is bent by " + fixed(angle * kDegrees, 0) +
                                      " degrees within its last " + plain(bent) + " mm.";
  chart.summary += " The last " + exact(shown) + " mm are drawn to scale.";
  chart.table.columns = {"Bend from the tip, mm", "Length, mm", "Angle, degrees"};
  for (const TipBend& bend : bends) {
    chart.table.rows.push_back(
        {plain(bend.from_tip), plain(bend.length), fixed(bend.angle * kDegrees, 1)});
  }

  const std::vector<Point> line = tip_line(bends, shown);
  double low_x = 0.0, high_x = 0.0, low_y = 0.0, high_y = 0.0;
  for (const Point& point : line) {
    low_x = std::min(low_x, point.x), high_x = std::max(high_x, point.x);
    low_y = std::min(low_y, point.y), high_y = std::max(high_y, point.y);
  }
  const double margin = 30.0;
  const double scale = std::min((kWidth - 2.0 * margin) / (high_x - low_x + outer_diameter),
                                (kHeight - 3.0 * margin) / (high_y - low_y + outer_diameter));
  const double off_x = (kWidth - scale * (high_x - low_x)) / 2.0 - scale * low_x;
  const double base_y = (kHeight - margin + scale * (high_y + low_y)) / 2.0;
  std::vector<Point> drawn;
  for (const Point& point : line) {
    drawn.push_back({off_x + scale * point.x, base_y - scale * point.y});
  }
  Svg svg(id, kWidth, kHeight, chart.title, chart.summary);
  svg.polyline(drawn, {colour::kText, scale * outer_diameter, "", "series-you"});
  svg.text({drawn.back().x, drawn.back().y - scale * outer_diameter / 2.0 - 8.0}, "tip",
           Anchor::middle, colour::kText2, "lab2");
  const double bar = round_length(shown / 3.0);
  const double y = kHeight - 18.0;
  svg.line({margin, y}, {margin + scale * bar, y}, {colour::kText, 2.0, "", "axis"});
  for (const double x : {margin, margin + scale * bar}) {
    svg.line({x, y - 4.0}, {x, y + 4.0}, {colour::kText, 2.0, "", "axis"});
  }
  svg.text({margin + scale * bar + 8.0, y + 4.0}, exact(bar) + " mm", Anchor::start, colour::kText2,
           "ax");
  chart.svg = svg.finish();
  return chart;
}

}  // namespace reports
