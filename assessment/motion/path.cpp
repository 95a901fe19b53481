#include "assessment/motion/path.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace assessment {

std::vector<double> segment_lengths(std::span<const Point> points) {
  std::vector<double> lengths;
  if (points.size() < 2) return lengths;
  lengths.reserve(points.size() - 1);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point& p = points[i - 1];
    const Point& q = points[i];
    lengths.push_back(std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]));
  }
  return lengths;
}

double path_length(std::span<const Point> points) {
  const std::vector<double> lengths = segment_lengths(points);
  return std::accumulate(lengths.begin(), lengths.end(), 0.0);
}

std::vector<double> speeds(std::span<const Point> points, std::span<const double> times) {
  assert(points.size() == times.size());
  std::vector<double> result = segment_lengths(points);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double duration = times[i + 1] - times[i];
    result[i] = duration > 0.0 ? result[i] / duration : 0.0;
  }
  return result;
}

double time_in_runs(const std::vector<bool>& idle, std::span<const double> times, double shortest) {
  assert(idle.empty() || times.size() == idle.size() + 1);
  // slack for the rounding of times, so that a run of exactly the shortest length counts
  const double least = shortest - 1e-9;
  double total = 0.0;
  for (std::size_t begin = 0; begin < idle.size();) {
    std::size_t end = begin;
    while (end < idle.size() && idle[end]) ++end;
    const double run = times[end] - times[begin];
    if (end > begin && run >= least) total += run;
    begin = std::max(end, begin + 1);
  }
  return total;
}

}  // namespace assessment
