#include "reports/series.h"

#include <algorithm>
#include <array>

namespace reports {
namespace {

constexpr std::array<const char*, 4> kDashes = {"", "6 4", "2 3", "8 3 2 3"};
constexpr double kLabelHeight = 15.0;

}  // namespace

Look expert_look(std::size_t index) { return {colour::kExpert, "series-expert", true, index}; }
Look novice_look(std::size_t index) { return {colour::kNovice, "series-novice", false, index}; }
Look own_look() { return {colour::kText, "series-you", true, 0}; }

void draw_marker(Svg& svg, Point at, const Look& look, double size) {
  const std::string fill = look.filled ? look.colour : colour::kSurface;
  const std::string paint = "fill=\"" + fill + "\" stroke=\"" + look.colour +
                            "\" stroke-width=\"1.5\" class=\"" + look.css_class +
                            (look.filled ? " filled" : " hollow") + "\"/>";
  const auto at_text = [&](double dx, double dy) {
    return coordinate(at.x + dx) + "," + coordinate(at.y + dy);
  };
  switch (look.index % 4) {
    case 0:
      svg.raw("<circle cx=\"" + coordinate(at.x) + "\" cy=\"" + coordinate(at.y) + "\" r=\"" +
              coordinate(size) + "\" " + paint);
      break;
    case 1:
      svg.raw("<rect x=\"" + coordinate(at.x - size) + "\" y=\"" + coordinate(at.y - size) +
              "\" width=\"" + coordinate(2.0 * size) + "\" height=\"" + coordinate(2.0 * size) +
              "\" " + paint);
      break;
    case 2:
      svg.raw("<polygon points=\"" + at_text(0, -1.3 * size) + " " + at_text(1.3 * size, 0) + " " +
              at_text(0, 1.3 * size) + " " + at_text(-1.3 * size, 0) + "\" " + paint);
      break;
    default:
      svg.raw("<polygon points=\"" + at_text(0, -1.2 * size) + " " + at_text(1.2 * size, size) +
              " " + at_text(-1.2 * size, size) + "\" " + paint);
  }
}

void draw_series(Svg& svg, const std::vector<Point>& points, const Look& look, double size) {
  // the dash moves on each time the markers start again, so that 16 people differ
  const std::size_t dash = (look.index + look.index / kDashes.size()) % kDashes.size();
  svg.polyline(points, {look.colour, 1.5, kDashes[dash], look.css_class});
  for (const Point& point : points) draw_marker(svg, point, look, size);
}

void draw_end_labels(Svg& svg, double x, std::vector<EndLabel> labels, double top, double bottom) {
  std::stable_sort(labels.begin(), labels.end(),
                   [](const EndLabel& a, const EndLabel& b) { return a.y < b.y; });
  // push down what overlaps, then push the whole stack up if it left the frame
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double least = i == 0 ? top : labels[i - 1].y + kLabelHeight;
    labels[i].y = std::max(labels[i].y, least);
  }
  double most = bottom;
  for (std::size_t i = labels.size(); i-- > 0;) {
    labels[i].y = std::min(labels[i].y, most);
    most = labels[i].y - kLabelHeight;
  }
  for (const EndLabel& label : labels) {
    const std::string words = shortened(label.words, svg.width() - x - 4.0, true, true);
    svg.text({x, label.y + 4.0}, words, Anchor::start, label.colour, label.css_class, true,
             label.words);
  }
}

}  // namespace reports
