// Zero-phase low-pass: a 2nd order Butterworth filter run forwards and backwards, so that nothing
// is delayed. The gain at frequency f is |H|^2 = 1 / (1 + (tan(pi f / rate) / tan(pi cut /
// rate))^4). The ends are continued by point reflection, as scipy.signal.filtfilt does.
#pragma once

#include <span>
#include <vector>

namespace assessment {

// The cut-off that motion metrics use; part of their version.
inline constexpr double kMotionCutOff = 8.0;  // Hz

// `cut_off` and `rate` in Hz, 0 < cut_off < rate / 2. Fewer than two values come back unchanged.
std::vector<double> low_pass(std::span<const double> values, double rate,
                             double cut_off = kMotionCutOff);

}  // namespace assessment
