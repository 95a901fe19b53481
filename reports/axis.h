// From numbers to places on the paper, with round ticks.
#pragma once

#include <string>
#include <vector>

#include "reports/svg.h"

namespace reports {

// Maps [low, high] linearly onto [from, to] (which may run downwards).
struct Scale {
  double low = 0.0, high = 1.0;
  double from = 0.0, to = 1.0;
  double operator()(double value) const {
    return from + (value - low) / (high - low) * (to - from);
  }
};

// About `count` round values that lie within or just around [low, high]: 200, 250, 300, ...
std::vector<double> round_ticks(double low, double high, int count);

// All with the same decimals, as many as the finest needs.
std::vector<std::string> tick_texts(const std::vector<double>& ticks);

// The frame of a chart with values upwards and something counted to the right.
struct Frame {
  double left = 44.0, right = 120.0, top = 26.0, bottom = 34.0;  // margins, px
};

// Draws grid lines, tick labels and the unit above the axis; returns the scale of the values.
Scale draw_value_axis(Svg& svg, const Frame& frame, double low, double high,
                      const std::string& unit);

}  // namespace reports
