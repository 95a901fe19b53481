// Length and speed of a path of points p_0 .. p_{n-1} at times t_0 .. t_{n-1}.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace assessment {

using Point = std::array<double, 3>;  // mm

// |p_i - p_{i-1}| for i = 1 .. n-1, mm. Empty for fewer than two points.
std::vector<double> segment_lengths(std::span<const Point> points);

// Their sum, mm.
double path_length(std::span<const Point> points);

// v_i = |p_i - p_{i-1}| / (t_i - t_{i-1}), mm/s; n - 1 of them. Times ascend; an interval without
// duration has speed 0.
std::vector<double> speeds(std::span<const Point> points, std::span<const double> times);

// The sum of the intervals for which `idle` holds in runs of at least `shortest` s. times[i] and
// times[i + 1] bound interval i; `idle` has one entry per interval.
double time_in_runs(const std::vector<bool>& idle, std::span<const double> times, double shortest);

}  // namespace assessment
