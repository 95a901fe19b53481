#include "sim/validation/turned_wire.h"

#include <cmath>
#include <numbers>

namespace sim::validation {
namespace {

constexpr int kIntervals = 1000;  // of the Runge-Kutta integration, from the tip to the base

}  // namespace

double base_angle(double a, double tip_angle) {
  const double h = 1.0 / kIntervals;
  double angle = tip_angle;
  double rate = 0.0;
  for (int i = 0; i < kIntervals; ++i) {
    const double k1 = rate, l1 = a * std::sin(angle);
    const double k2 = rate + 0.5 * h * l1, l2 = a * std::sin(angle + 0.5 * h * k1);
    const double k3 = rate + 0.5 * h * l2, l3 = a * std::sin(angle + 0.5 * h * k2);
    const double k4 = rate + h * l3, l4 = a * std::sin(angle + h * k3);
    angle += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    rate += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
  }
  return angle;
}

std::optional<double> whip_angle(double a) {
  constexpr double kPi = std::numbers::pi;
  if (a <= kPi * kPi / 4.0) return std::nullopt;
  // the base's angle has one maximum over the tip's angles up to pi: golden section
  const double golden = (std::sqrt(5.0) - 1.0) / 2.0;
  double low = 0.0;
  double high = kPi;
  while (high - low > 1e-7) {
    const double left = high - golden * (high - low);
    const double right = low + golden * (high - low);
    if (base_angle(a, left) < base_angle(a, right)) {
      low = left;
    } else {
      high = right;
    }
  }
  return base_angle(a, 0.5 * (low + high));
}

}  // namespace sim::validation
