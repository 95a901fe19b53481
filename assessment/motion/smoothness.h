// How smooth a movement is, from its speed at a fixed rate. Both measures are free of the unit of
// speed and defined for one discrete movement (a stroke): trim standstill first, and never compare
// values across tasks.
#pragma once

#include <optional>
#include <span>

namespace assessment {

// What sparc() computed, for those who want to see inside.
struct SpectralArc {
  double length = 0.0;       // SPARC itself: negative, closer to zero is smoother
  int transform_size = 0;    // nfft
  int selected_bins = 0;     // bins from the first to the last with magnitude >= 0.05
  double cut_frequency = 0;  // Hz, the last of them
};

// Spectral arc length (Balasubramanian, Melendez-Calderon, Roby-Brami, Burdet, J. NeuroEng.
// Rehabil. 12:112, 2015):
//
//     nfft = 2^(ceil(log2 N) + 4),  M = |FFT(v)| / max,  f <= 10 Hz, cut where M >= 0.05
//     SPARC = - sum sqrt((df / (f_last - f_first))^2 + dM^2)
//
// Absent for fewer than two values, a rate that is not positive, a value that is not finite, or
// no movement at all.
std::optional<SpectralArc> spectral_arc(std::span<const double> speed, double rate);
std::optional<double> sparc(std::span<const double> speed, double rate);

// T^3 / v_peak^2 * sum (d2v / dt2)^2 dt, T = N dt, d2v by second differences; negative as in the
// literature, and its logarithm -ln(...). Absent for fewer than three values, no movement, or a
// speed without any second difference (its logarithm has no end).
std::optional<double> dimensionless_jerk(std::span<const double> speed, double rate);
std::optional<double> log_dimensionless_jerk(std::span<const double> speed, double rate);

// The part from the first to the last value above `threshold`, empty when there is none.
std::span<const double> trimmed(std::span<const double> speed, double threshold);

}  // namespace assessment
