#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/contact/surface_distance.h"
#include "sim/contact/triangle_tree.h"

namespace sim {
namespace {

Vec3 random_point(std::mt19937& random, double extent) {
  std::uniform_real_distribution<double> along(-extent, extent);
  const double x = along(random), y = along(random);
  return {x, y, along(random)};
}

// Two steps of an exhaustive search over the triangle's points: an upper bound that comes within
// `error` of the truth.
double searched_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  double best_v = 0.0, best_w = 0.0, best = 1e300, range = 1.0;
  double from_v = 0.0, from_w = 0.0;
  for (int round = 0; round < 8; ++round) {
    constexpr int kSteps = 40;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) {
        const double v = std::clamp(from_v + range * i / kSteps, 0.0, 1.0);
        const double w = std::clamp(from_w + range * j / kSteps, 0.0, 1.0 - v);
        const double distance = (a + v * (b - a) + w * (c - a) - p).norm();
        if (distance >= best) continue;
        best = distance, best_v = v, best_w = w;
      }
    }
    range /= 8.0;
    from_v = best_v - range / 2.0;
    from_w = best_w - range / 2.0;
  }
  return best;
}

TEST(NearestOnTriangle, MatchesAnExhaustiveSearch) {
  std::mt19937 random(11);
  for (int i = 0; i < 30; ++i) {
    const Vec3 a = random_point(random, 1.0), b = random_point(random, 1.0),
               c = random_point(random, 1.0), p = random_point(random, 2.0);
    const TrianglePoint found = nearest_on_triangle(p, a, b, c);
    EXPECT_NEAR(std::sqrt(found.squared_distance), searched_distance(p, a, b, c), 1e-5);
    EXPECT_NEAR(found.weights.sum(), 1.0, 1e-12);
    EXPECT_GE(found.weights.minCoeff(), 0.0);
    const Vec3 named = found.weights[0] * a + found.weights[1] * b + found.weights[2] * c;
    EXPECT_LT((named - found.position).norm(), 1e-12);
  }
}

TEST(NearestOnTriangle, OfANeedleIsOnItsEdge) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(2, 0, 0);
  EXPECT_NEAR(nearest_on_triangle({1.5, 1, 0}, a, b, c).squared_distance, 1.0, 1e-12);
  EXPECT_NEAR(nearest_on_triangle({3, 0, 0}, a, b, c).squared_distance, 1.0, 1e-12);
  EXPECT_NEAR(nearest_on_triangle({0, 2, 0}, a, a, a).squared_distance, 4.0, 1e-12);
}

TriangleMesh random_triangles(int count) {
  std::mt19937 random(12);
  TriangleMesh mesh;
  for (std::int32_t i = 0; i < count; ++i) {
    const Vec3 middle = random_point(random, 10.0);
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(middle + random_point(random, 1.0));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

TEST(TriangleTree, MatchesBruteForce) {
  const TriangleMesh mesh = random_triangles(500);
  const TriangleTree tree(mesh);
  std::mt19937 random(13);
  NearestTriangle close_by;
  for (int i = 0; i < 500; ++i) {
    const Vec3 point = random_point(random, 15.0);
    double expected = 1e300;
    for (const auto& t : mesh.triangles) {
      const auto corner = [&](std::size_t k) {
        return mesh.vertices[static_cast<std::size_t>(t[k])];
      };
      expected = std::min(
          expected, nearest_on_triangle(point, corner(0), corner(1), corner(2)).squared_distance);
    }
    EXPECT_EQ(tree.nearest(point).squared_distance, expected);
    close_by = tree.nearest(point, close_by);  // any hint, however bad, gives the same
    EXPECT_EQ(close_by.squared_distance, expected);
    const double distance = std::sqrt(expected);
    EXPECT_EQ(tree.nearest(point, 0.9 * distance).triangle, -1);
    EXPECT_GE(tree.nearest(point, 1.1 * distance).triangle, 0);
  }
}

TEST(TriangleTree, RefusesWhatIsNoSurface) {
  EXPECT_THROW(TriangleTree(TriangleMesh{}), std::invalid_argument);
  TriangleMesh mesh = random_triangles(2);
  mesh.triangles[0][1] = 99;
  EXPECT_THROW(TriangleTree{mesh}, std::invalid_argument);
  mesh = random_triangles(2);
  mesh.vertices[3].x() = NAN;
  EXPECT_THROW(TriangleTree{mesh}, std::invalid_argument);
}

// A box of 4 x 6 x 8 about the origin, twelve triangles.
TriangleMesh box() {
  TriangleMesh mesh;
  for (int c = 0; c < 8; ++c) {
    mesh.vertices.emplace_back(c & 1 ? 2 : -2, c & 2 ? 3 : -3, c & 4 ? 4 : -4);
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TEST(SurfaceDistance, OfABoxIsExactInsideAndOutsideAndAtItsCorners) {
  const TriangleMesh mesh = box();
  const SurfaceDistance surface(mesh);
  std::mt19937 random(14);
  NearestTriangle close_by;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random_point(random, 6.0);
    const Vec3 beyond = p.cwiseAbs() - Vec3(2, 3, 4);
    const double outside = beyond.cwiseMax(0.0).norm();
    const double expected = outside > 0.0 ? -outside : -beyond.maxCoeff();
    EXPECT_NEAR(surface.sample(p, close_by).distance, expected, 1e-9);
    EXPECT_NEAR(surface.facet_distance(p), expected, 1e-9);
  }
}

TEST(SurfaceDistance, RefusesAnOpenSurface) {
  TriangleMesh mesh = box();
  mesh.triangles.pop_back();
  EXPECT_THROW(SurfaceDistance{mesh}, std::invalid_argument);
  mesh = box();
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);  // one facet turned over
  EXPECT_THROW(SurfaceDistance{mesh}, std::invalid_argument);
}

}  // namespace
}  // namespace sim
