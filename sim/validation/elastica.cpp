#include "sim/validation/elastica.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace sim::validation {
namespace {

constexpr int kIntervals =
    2000;  // per stretch, of the Runge-Kutta integration; error far below 1e-9

using State = std::array<double, 4>;  // theta, moment, x, y

template <typename Slope>
State runge_kutta(const State& y, double h, const Slope& slope) {
  const auto shifted = [&y](const State& k, double factor) {
    State result = y;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += factor * k[i];
    return result;
  };
  const State k1 = slope(y);
  const State k2 = slope(shifted(k1, 0.5 * h));
  const State k3 = slope(shifted(k2, 0.5 * h));
  const State k4 = slope(shifted(k3, h));
  State result = y;
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
  }
  return result;
}

struct Shot {
  State end{};
  double lowest_y = 0.0;
  double highest_y = 0.0;
  bool unloaded_early = false;  // the moment changed sign before the end
};

// A stretch of constant rest curvature.
struct Stretch {
  double length = 0.0;
  double curvature = 0.0;
};

struct Force {
  double x = 0.0, y = 0.0;
};

std::array<double, 4> slope_at(const std::array<double, 4>& y, double curvature,
                               double bending_stiffness, const Force& force) {
  const double cosine = std::cos(y[0]);
  const double sine = std::sin(y[0]);
  return {curvature + y[1] / bending_stiffness, force.x * sine - force.y * cosine, cosine, sine};
}

// Stretch by stretch, so that no interval of the integration straddles a jump in curvature.
Shot shoot(std::span<const Stretch> stretches, double bending_stiffness, const Force& force,
           double clamp_moment) {
  Shot shot;
  shot.end = {0.0, clamp_moment, 0.0, 0.0};
  for (const Stretch& stretch : stretches) {
    const auto slope = [&](const State& y) {
      return slope_at(y, stretch.curvature, bending_stiffness, force);
    };
    const double h = stretch.length / kIntervals;
    for (int i = 0; i < kIntervals; ++i) {
      shot.end = runge_kutta(shot.end, h, slope);
      shot.lowest_y = std::min(shot.lowest_y, shot.end[3]);
      shot.highest_y = std::max(shot.highest_y, shot.end[3]);
      if (shot.end[1] < 0.0) shot.unloaded_early = true;
    }
  }
  return shot;
}

Elastica elastica(const Shot& shot) {
  return {.x = shot.end[2],
          .y = shot.end[3],
          .angle = shot.end[0],
          .lowest_y = shot.lowest_y,
          .highest_y = shot.highest_y};
}

Force force_along(double load, double direction) {
  return {load * std::cos(direction), load * std::sin(direction)};
}

// With theta'^2 EI / 2 + P cos(direction - theta) = const the moment at the clamp is below
// sqrt(2 P EI (1 - cos(direction))), and the larger it is the later the moment vanishes. Bisect.
double cantilever_clamp_moment(double length, double bending_stiffness, double load,
                               double direction) {
  const Stretch straight[] = {{length, 0.0}};
  const Force force = force_along(load, direction);
  double low = 0.0;
  double high = std::sqrt(2.0 * load * bending_stiffness * (1.0 - std::cos(direction)));
  high = std::min(high, load * length * (1.0 + 1e-9));
  for (int i = 0; i < 100 && high > low; ++i) {
    const double middle = 0.5 * (low + high);
    const bool early = shoot(straight, bending_stiffness, force, middle).unloaded_early;
    (early ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

Elastica loaded_cantilever(double length, double bending_stiffness, double load, double direction) {
  const Stretch straight[] = {{length, 0.0}};
  const Force force = force_along(load, direction);
  return elastica(shoot(straight, bending_stiffness, force,
                        cantilever_clamp_moment(length, bending_stiffness, load, direction)));
}

std::vector<std::pair<double, double>> loaded_cantilever_shape(double length,
                                                               double bending_stiffness,
                                                               double load, double direction,
                                                               int intervals) {
  const Force force = force_along(load, direction);
  const auto slope = [&](const State& y) { return slope_at(y, 0.0, bending_stiffness, force); };
  const int finer = 1 + kIntervals / intervals;
  const double h = length / (static_cast<double>(intervals) * finer);
  State state = {0.0, cantilever_clamp_moment(length, bending_stiffness, load, direction), 0.0,
                 0.0};
  std::vector<std::pair<double, double>> points = {{0.0, 0.0}};
  for (int i = 0; i < intervals; ++i) {
    for (int k = 0; k < finer; ++k) state = runge_kutta(state, h, slope);
    points.emplace_back(state[2], state[3]);
  }
  return points;
}

Elastica bent_cantilever(double length, double bending_stiffness, double bend_length,
                         double curvature, double force) {
  const Stretch stretches[] = {{length - bend_length, 0.0}, {bend_length, curvature}};
  // the moment at the clamp is F x(end): iterate with the secant method on M(end) = 0
  double previous = 0.0;
  const Force across{0.0, force};
  Shot shot = shoot(stretches, bending_stiffness, across, previous);
  double previous_error = shot.end[1];
  double moment = -previous_error;
  for (int i = 0; i < 60; ++i) {
    shot = shoot(stretches, bending_stiffness, across, moment);
    const double error = shot.end[1];
    if (std::abs(error) < 1e-13 * (1.0 + std::abs(force) * length) || error == previous_error) {
      break;
    }
    const double next = moment - error * (moment - previous) / (error - previous_error);
    previous = moment;
    previous_error = error;
    moment = next;
  }
  return elastica(shot);
}

// With the modulus k = sin(half the angle at the end): P = (2 K / pi)^2 P_Euler, end distance
// L (2 E / K - 1), middle deflection L k / K (Love, Treatise on Elasticity, art. 263).
BuckledRod buckled_rod(double shortening) {
  double low = 0.0;
  double high = 0.99;
  for (int i = 0; i < 200; ++i) {
    const double k = 0.5 * (low + high);
    const double shortened = 2.0 - 2.0 * std::comp_ellint_2(k) / std::comp_ellint_1(k);
    (shortened < shortening ? low : high) = k;
  }
  const double k = 0.5 * (low + high);
  const double complete = std::comp_ellint_1(k);
  const double ratio = 2.0 * complete / std::numbers::pi;
  return {.load_ratio = ratio * ratio, .deflection_ratio = k / complete};
}

}  // namespace sim::validation
