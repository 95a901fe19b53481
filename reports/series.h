// The looks of series: people are told apart by marker and dash, groups by filled and hollow;
// colour only repeats it.
#pragma once

#include <string>
#include <vector>

#include "reports/svg.h"

namespace reports {

struct Look {
  std::string colour;
  std::string css_class;  // series-expert, series-novice, series-you
  bool filled = true;
  std::size_t index = 0;  // of the person within the group: chooses marker and dash
};

Look expert_look(std::size_t index);
Look novice_look(std::size_t index);
Look own_look();

void draw_marker(Svg& svg, Point at, const Look& look, double size = 4.0);
void draw_series(Svg& svg, const std::vector<Point>& points, const Look& look, double size = 4.0);

// A label beside the end of a series. Labels that would overlap are moved apart, and one that would
// leave the drawing is shortened in its middle.
struct EndLabel {
  double y = 0.0;
  std::string words;
  std::string colour, css_class;
};
void draw_end_labels(Svg& svg, double x, std::vector<EndLabel> labels, double top, double bottom);

}  // namespace reports
