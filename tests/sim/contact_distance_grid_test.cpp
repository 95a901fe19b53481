#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sim/anatomy/tube.h"
#include "sim/base/units.h"
#include "sim/contact/distance_grid.h"
#include "sim/contact/triangle_tree.h"

namespace sim {
namespace {

using namespace base::units;

// 40 mm of straight tube of radius 3, not along the grid, from the mouth of a sheath.
TubeDescription slanted_tube() {
  TubeDescription tube;
  tube.start_radius = 3.0;
  tube.direction = Vec3(0.3, -0.5, 0.8);
  tube.legs = {{40.0, 0.0, 0.0, 3.0}};
  return tube;
}

const TriangleMesh& slanted_surface() {
  static const TriangleMesh mesh = tube_surface(slanted_tube(), 0.5);
  return mesh;
}

const DistanceGrid& slanted_grid() {
  static const DistanceGrid grid(slanted_surface());
  return grid;
}

WallSample sample_at(const Wall& wall, const Vec3& point) {
  WallSample sample;
  wall.sample({&point, 1}, {&sample, 1});
  return sample;
}

struct Errors {
  double distance_rms = 0.0, distance_max = 0.0;  // mm
  double normal_rms_deg = 0.0, normal_max_deg = 0.0;
};

// Against the closed form of a straight tube, at depths between `low` and `high` mm.
Errors errors_in_tube(const Wall& wall, double low, double high) {
  const Vec3 axis = slanted_tube().direction.normalized();
  const Vec3 across = axis.unitOrthogonal(), other = axis.cross(across);
  std::mt19937 random(21);
  std::uniform_real_distribution<double> along(2.0, 38.0), around(0.0, 2.0 * std::numbers::pi),
      depth(low, high);
  constexpr int kPoints = 20000;
  Errors errors;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = around(random), d = depth(random);
    const Vec3 outward = std::cos(angle) * across + std::sin(angle) * other;
    const WallSample found = sample_at(wall, along(random) * axis + (3.0 - d) * outward);
    const double distance_error = std::abs(found.distance - d);
    const double normal_error =
        std::atan2(found.normal.cross(outward).norm(), -found.normal.dot(outward)) / 1.0_deg;
    errors.distance_rms += distance_error * distance_error / kPoints;
    errors.normal_rms_deg += normal_error * normal_error / kPoints;
    errors.distance_max = std::max(errors.distance_max, distance_error);
    errors.normal_max_deg = std::max(errors.normal_max_deg, normal_error);
  }
  errors.distance_rms = std::sqrt(errors.distance_rms);
  errors.normal_rms_deg = std::sqrt(errors.normal_rms_deg);
  return errors;
}

TEST(DistanceGrid, MatchesTheTubeItWasSurveyedFrom) {
  // Where instruments touch: from a millimetre deep to half a millimetre beyond the wall. What the
  // prototype study needed for its solver to converge is 0.25 degrees and 0.01 mm rms at this
  // radius and spacing.
  const Errors errors = errors_in_tube(slanted_grid(), -0.5, 1.0);
  EXPECT_LT(errors.distance_rms, 0.001);
  EXPECT_LT(errors.distance_max, 0.005);
  EXPECT_LT(errors.normal_rms_deg, 0.1);
  EXPECT_LT(errors.normal_max_deg, 0.5);
  std::printf("distance %.5f mm rms, %.5f max; normal %.3f deg rms, %.3f max\n",
              errors.distance_rms, errors.distance_max, errors.normal_rms_deg,
              errors.normal_max_deg);
}

TEST(DistanceGrid, StaysSmoothTowardsTheMiddleOfTheLumen) {
  // 0.8 to 2 mm from the axis the field turns within few cells: errors grow as (spacing / that)^4
  const Errors errors = errors_in_tube(slanted_grid(), 1.0, 2.2);
  EXPECT_LT(errors.distance_rms, 0.005);
  EXPECT_LT(errors.normal_rms_deg, 0.5);
}

TEST(DistanceGrid, MatchesTheBendItWasSurveyedFrom) {
  TubeDescription tube;
  tube.start_radius = 3.0;
  tube.legs = {{20.0 * std::numbers::pi / 2.0, 90.0_deg, 0.0, 3.0}};
  const DistanceGrid grid(tube_surface(tube, 0.5));
  std::mt19937 random(22);
  std::uniform_real_distribution<double> turn(5.0_deg, 85.0_deg),
      around(0.0, 2.0 * std::numbers::pi), depth(-0.5, 1.0);
  for (int i = 0; i < 5000; ++i) {
    const double a = turn(random), b = around(random), d = depth(random);
    // the arc's centre is at x = 20; `out` points away from it
    const Vec3 out(-std::cos(a), 0.0, std::sin(a));
    const Vec3 radial = std::cos(b) * out + std::sin(b) * Vec3::UnitY();
    const Vec3 p = Vec3(20.0, 0.0, 0.0) + 20.0 * out + (3.0 - d) * radial;
    const WallSample found = sample_at(grid, p);
    EXPECT_NEAR(found.distance, d, 0.005);
    EXPECT_GT(-found.normal.dot(radial), std::cos(0.5_deg));
  }
}

TEST(DistanceGrid, MatchesBruteForceOverAllTriangles) {
  const TriangleMesh& mesh = slanted_surface();
  std::mt19937 random(23);
  std::uniform_real_distribution<double> along(-12.0, 42.0), across(-5.0, 5.0);
  const Vec3 axis = slanted_tube().direction.normalized();
  for (int i = 0; i < 100; ++i) {
    const Vec3 p = along(random) * axis + across(random) * axis.unitOrthogonal() +
                   Vec3(0.0, 0.0, across(random));
    double nearest = 1e300;
    for (const auto& t : mesh.triangles) {
      const auto corner = [&](std::size_t k) {
        return mesh.vertices[static_cast<std::size_t>(t[k])];
      };
      nearest = std::min(nearest,
                         nearest_on_triangle(p, corner(0), corner(1), corner(2)).squared_distance);
    }
    nearest = std::sqrt(nearest);
    if (nearest > 2.3) continue;  // near the axis the nearest wall point is not one point
    // facets cut the curve by up to edge^2 / (8 radius) = 0.02 mm; the grid does not
    EXPECT_NEAR(std::abs(sample_at(slanted_grid(), p).distance), nearest, 0.025);
  }
}

TEST(DistanceGrid, NormalIsTheSlopeOfTheDistance) {
  std::mt19937 random(24);
  std::uniform_real_distribution<double> along(2.0, 38.0), across(-3.2, 3.2);
  const Vec3 axis = slanted_tube().direction.normalized();
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  for (int i = 0; i < 2000; ++i) {
    const double a = across(random), b = across(random);
    // as deep as an instrument's middle gets while its surface touches
    if (std::hypot(a, b) < 1.8 || std::hypot(a, b) > 3.2) continue;
    const Vec3 p = along(random) * axis + a * u + b * v;
    const WallSample here = sample_at(slanted_grid(), p);
    constexpr double kStep = 1e-2;  // mm; distances are stored to 1e-7 of a millimetre
    Vec3 slope;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const Vec3 step = kStep * Vec3::Unit(k);
      slope[k] = (sample_at(slanted_grid(), p + step).distance -
                  sample_at(slanted_grid(), p - step).distance) /
                 (2.0 * kStep);
    }
    EXPECT_LT((slope - here.normal).norm(), 0.03);
  }
}

TEST(DistanceGrid, NormalIsContinuousAcrossCellsAndBricks) {
  // along straight lines through many cells, in steps of a micrometre
  const Vec3 axis = slanted_tube().direction.normalized();
  const Vec3 start = 5.0 * axis + 2.0 * axis.unitOrthogonal();
  Vec3 before = sample_at(slanted_grid(), start).normal;
  double turned = 0.0;
  for (int i = 1; i < 12000; ++i) {
    const Vec3 normal = sample_at(slanted_grid(), start + 1e-3 * i * axis).normal;
    turned = std::max(turned, (normal - before).norm());
    before = normal;
  }
  EXPECT_LT(turned, 1e-4);
}

TEST(DistanceGrid, NothingOutThereIsFree) {
  const DistanceGrid& grid = slanted_grid();
  const Vec3 axis = slanted_tube().direction.normalized();
  EXPECT_NEAR(sample_at(grid, 20.0 * axis + 4.0 * axis.unitOrthogonal()).distance, -1.0, 0.01);
  EXPECT_EQ(sample_at(grid, 20.0 * axis + 15.0 * axis.unitOrthogonal()).distance,
            -DistanceGrid::kLost);
  EXPECT_EQ(sample_at(grid, Vec3(1e6, 0.0, 0.0)).distance, -DistanceGrid::kLost);
  EXPECT_EQ(sample_at(grid, Vec3(NAN, 0.0, 0.0)).distance, -DistanceGrid::kLost);
  EXPECT_NEAR(sample_at(grid, Vec3(1e300, 0.0, 0.0)).normal.norm(), 1.0, 1e-12);
}

TEST(DistanceGrid, InTheMiddleOfAWideLumenTheWallIsFarAway) {
  TubeDescription tube;
  tube.start_radius = 12.0;
  tube.legs = {{10.0, 0.0, 0.0, 12.0}};
  const DistanceGrid grid(tube_surface(tube, 2.0), {.spacing = 1.0});
  EXPECT_EQ(sample_at(grid, Vec3(0.0, 0.0, 5.0)).distance, 3.0);
  EXPECT_EQ(sample_at(grid, Vec3(4.0, 0.0, 5.0)).distance, 3.0);
  EXPECT_NEAR(sample_at(grid, Vec3(10.0, 0.0, 5.0)).distance, 2.0, 0.01);
}

TEST(DistanceGrid, IsTheSameEveryTime) {
  const DistanceGrid again(slanted_surface());
  std::mt19937 random(25);
  std::uniform_real_distribution<double> within(-5.0, 35.0);
  for (int i = 0; i < 5000; ++i) {
    const double x = within(random), y = within(random);
    const Vec3 p(0.3 * x, -0.5 * y, within(random));
    const WallSample a = sample_at(slanted_grid(), p), b = sample_at(again, p);
    ASSERT_EQ(a.distance, b.distance);
    ASSERT_EQ(a.normal, b.normal);
  }
}

TEST(DistanceGrid, HasALimitOfMemoryAndRefusesWhatMakesNoSense) {
  DistanceGridOptions options;
  options.max_bytes = 1000000;
  EXPECT_THROW(DistanceGrid(slanted_surface(), options), std::invalid_argument);
  EXPECT_LT(slanted_grid().bytes(), 10000000U);
  options = {};
  options.spacing = 0.0;
  EXPECT_THROW(DistanceGrid(slanted_surface(), options), std::invalid_argument);
  EXPECT_THROW(DistanceGrid(TriangleMesh{}), std::invalid_argument);
}

}  // namespace
}  // namespace sim
