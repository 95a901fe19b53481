#include "assessment/motion/peaks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace assessment {
namespace {

std::vector<std::size_t> local_maxima(std::span<const double> values) {
  std::vector<std::size_t> peaks;
  for (std::size_t i = 1; i + 1 < values.size();) {
    if (values[i - 1] >= values[i]) {
      ++i;
      continue;
    }
    std::size_t end = i;  // last of a flat top
    while (end + 1 < values.size() && values[end + 1] == values[i]) ++end;
    if (end + 1 < values.size() && values[end + 1] < values[i]) peaks.push_back((i + end) / 2);
    i = end + 1;
  }
  return peaks;
}

// From the highest down, each peak removes the lower ones around it; of equal ones the later wins.
std::vector<std::size_t> thinned(std::vector<std::size_t> peaks, std::span<const double> values,
                                 std::size_t distance) {
  std::vector<std::size_t> order(peaks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
    return values[peaks[x]] < values[peaks[y]];
  });
  std::vector<bool> kept(peaks.size(), true);
  for (auto it = order.rbegin(); it != order.rend(); ++it) {
    const std::size_t centre = *it;
    if (!kept[centre]) continue;
    for (std::size_t k = centre; k-- > 0 && peaks[centre] - peaks[k] < distance;) kept[k] = false;
    for (std::size_t k = centre + 1; k < peaks.size() && peaks[k] - peaks[centre] < distance; ++k) {
      kept[k] = false;
    }
  }
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < peaks.size(); ++k) {
    if (kept[k]) result.push_back(peaks[k]);
  }
  return result;
}

// Whether the values drop by `prominence` on the way from the peak before they rise above it.
// `step` is +1 or -1.
bool drops(std::span<const double> values, std::size_t peak, double prominence,
           std::ptrdiff_t step) {
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  for (auto i = static_cast<std::ptrdiff_t>(peak); i >= 0 && i < count; i += step) {
    const double value = values[static_cast<std::size_t>(i)];
    if (value > values[peak]) return false;
    if (values[peak] - value >= prominence) return true;
  }
  return false;
}

}  // namespace

std::vector<std::size_t> find_peaks(std::span<const double> values, const PeakLimits& limits) {
  std::vector<std::size_t> peaks = local_maxima(values);
  std::erase_if(peaks, [&](std::size_t peak) { return values[peak] < limits.height; });
  peaks = thinned(std::move(peaks), values, limits.distance);
  std::erase_if(peaks, [&](std::size_t peak) {
    return !drops(values, peak, limits.prominence, -1) ||
           !drops(values, peak, limits.prominence, +1);
  });
  return peaks;
}

int count_submovements(std::span<const double> speed, double rate) {
  if (speed.empty()) return 0;
  const double peak = *std::max_element(speed.begin(), speed.end());
  if (!(peak > 0.0)) return 0;
  PeakLimits limits;
  limits.height = 0.10 * peak;
  limits.prominence = 0.05 * peak;
  limits.distance = static_cast<std::size_t>(std::max(1.0, std::ceil(0.1 * rate - 1e-9)));
  return static_cast<int>(find_peaks(speed, limits).size());
}

}  // namespace assessment
