#include "sim/validation/twisted_rod.h"

#include <cmath>

#include <Eigen/Dense>

namespace sim::validation {

std::complex<double> twisted_rod_deflection(double torque) {
  using Complex = std::complex<double>;
  const Complex i_m(0.0, torque);
  // 1, s, s^2, exp(i M s) and their derivatives
  const auto basis = [&i_m](int function, int derivative, double s) -> Complex {
    if (function == 3) return std::pow(i_m, derivative) * std::exp(i_m * s);
    if (derivative > function) return 0.0;
    double factor = 1.0;
    for (int k = 0; k < derivative; ++k) factor *= function - k;
    return factor * std::pow(s, function - derivative);
  };
  // four coefficients left of the middle, four right of it
  Eigen::Matrix<Complex, 8, 8> matrix = Eigen::Matrix<Complex, 8, 8>::Zero();
  Eigen::Matrix<Complex, 8, 1> right = Eigen::Matrix<Complex, 8, 1>::Zero();
  for (int f = 0; f < 4; ++f) {
    for (int derivative = 0; derivative < 2; ++derivative) {
      matrix(derivative, f) = basis(f, derivative, 0.0);
      matrix(2 + derivative, 4 + f) = basis(f, derivative, 1.0);
    }
    for (int derivative = 0; derivative < 4; ++derivative) {
      matrix(4 + derivative, f) = -basis(f, derivative, 0.5);
      matrix(4 + derivative, 4 + f) = basis(f, derivative, 0.5);
    }
  }
  right(7) = 192.0;  // the jump of u''', in units of the untwisted deflection
  const Eigen::Matrix<Complex, 8, 1> coefficients = matrix.fullPivLu().solve(right);
  Complex middle = 0.0;
  for (int f = 0; f < 4; ++f) middle += coefficients(f) * basis(f, 0, 0.5);
  return middle;
}

std::optional<double> extrapolated_critical_torque(const TorqueResponse (&responses)[3]) {
  const auto [m1, d1] = responses[0];
  const auto [m2, d2] = responses[1];
  const auto [m3, d3] = responses[2];
  if (!(d2 > d1 && d3 > d2)) return std::nullopt;
  const double wanted = (d2 - d1) / (d3 - d2);
  const auto ratio = [=](double critical) {
    const auto term = [critical](double m) { return 1.0 / (critical * critical - m * m); };
    return (term(m2) - term(m1)) / (term(m3) - term(m2));
  };
  // the ratio grows with the critical torque, from nothing at the largest torque measured
  double low = m3 * (1.0 + 1e-9);
  double high = 2.0 * m3;
  if (wanted > ratio(high)) return std::nullopt;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (ratio(middle) < wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace sim::validation
