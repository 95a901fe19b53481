#include "assessment/motion/smoothness.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include <unsupported/Eigen/FFT>

namespace assessment {
namespace {

constexpr int kPadding = 4;                 // powers of two beyond the next one
constexpr double kHighestFrequency = 10.0;  // Hz
constexpr double kSmallestMagnitude = 0.05;

bool usable(std::span<const double> speed, double rate, std::size_t least) {
  return speed.size() >= least && rate > 0.0 && std::isfinite(rate) &&
         std::all_of(speed.begin(), speed.end(), [](double v) { return std::isfinite(v); });
}

std::size_t transform_size(std::size_t count) {
  std::size_t size = 1;
  while (size < count) size *= 2;
  return size << kPadding;
}

// |FFT| of the zero-padded speed from 0 Hz to half the rate, divided by its largest value.
std::vector<double> normalised_magnitudes(std::span<const double> speed, std::size_t size) {
  std::vector<double> padded(size, 0.0);
  std::copy(speed.begin(), speed.end(), padded.begin());
  std::vector<std::complex<double>> spectrum;
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  transform.fwd(spectrum, padded);

  std::vector<double> magnitudes(spectrum.size());
  std::transform(spectrum.begin(), spectrum.end(), magnitudes.begin(),
                 [](const std::complex<double>& value) { return std::abs(value); });
  const double largest = *std::max_element(magnitudes.begin(), magnitudes.end());
  if (!(largest > 0.0) || !std::isfinite(largest)) return {};
  for (double& magnitude : magnitudes) magnitude /= largest;
  return magnitudes;
}

}  // namespace

std::optional<SpectralArc> spectral_arc(std::span<const double> speed, double rate) {
  if (!usable(speed, rate, 2)) return std::nullopt;
  const std::size_t size = transform_size(speed.size());
  const std::vector<double> magnitudes = normalised_magnitudes(speed, size);
  const double spacing = rate / static_cast<double>(size);  // Hz between bins

  std::size_t first = magnitudes.size(), last = 0;
  for (std::size_t k = 0; k < magnitudes.size(); ++k) {
    if (static_cast<double>(k) * spacing > kHighestFrequency) break;
    if (magnitudes[k] < kSmallestMagnitude) continue;
    first = std::min(first, k);
    last = k;
  }
  if (first >= last) return std::nullopt;

  const double step = 1.0 / static_cast<double>(last - first);
  SpectralArc arc;
  arc.transform_size = static_cast<int>(size);
  arc.selected_bins = static_cast<int>(last - first) + 1;
  arc.cut_frequency = static_cast<double>(last) * spacing;
  for (std::size_t k = first + 1; k <= last; ++k) {
    arc.length -= std::hypot(step, magnitudes[k] - magnitudes[k - 1]);
  }
  return arc;
}

std::optional<double> sparc(std::span<const double> speed, double rate) {
  const auto arc = spectral_arc(speed, rate);
  return arc ? std::optional(arc->length) : std::nullopt;
}

std::optional<double> dimensionless_jerk(std::span<const double> speed, double rate) {
  if (!usable(speed, rate, 3)) return std::nullopt;
  double peak = 0.0;
  for (const double v : speed) peak = std::max(peak, std::abs(v));
  if (peak == 0.0) return std::nullopt;

  // speed in peaks and time in samples: the measure has no dimension, so nothing else is left
  double squares = 0.0;
  for (std::size_t i = 2; i < speed.size(); ++i) {
    const double second = (speed[i] - 2.0 * speed[i - 1] + speed[i - 2]) / peak;
    squares += second * second;
  }
  const auto count = static_cast<double>(speed.size());
  return -count * count * count * squares;
}

std::optional<double> log_dimensionless_jerk(std::span<const double> speed, double rate) {
  const auto jerk = dimensionless_jerk(speed, rate);
  if (!jerk || *jerk == 0.0) return std::nullopt;
  return -std::log(-*jerk);
}

std::span<const double> trimmed(std::span<const double> speed, double threshold) {
  const auto moves = [threshold](double v) { return v > threshold; };
  const auto first = std::find_if(speed.begin(), speed.end(), moves);
  if (first == speed.end()) return {};
  const auto last = std::find_if(speed.rbegin(), speed.rend(), moves);
  return {first, last.base()};
}

}  // namespace assessment
