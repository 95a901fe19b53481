#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sim/anatomy/tube.h"
#include "sim/base/units.h"
#include "tests/support/surface.h"
#include "tests/support/vessels.h"

namespace sim {
namespace {

using namespace base::units;

TubeDescription quarter_turn() {
  TubeDescription tube;
  tube.start_radius = 3.0;
  tube.access = Vec3(10.0, 20.0, 30.0);
  tube.direction = Vec3(0.0, 0.0, 2.0);
  tube.legs = {{20.0, 0.0, 0.0, 3.0}, {30.0 * std::numbers::pi / 2.0, 90.0_deg, 0.0, 3.0}};
  return tube;
}

TEST(Tube, CentrelineOfAQuarterTurnEndsWhereACompassPutsIt) {
  const auto line = tube_centreline(quarter_turn(), 1.0);
  EXPECT_EQ(line.front().position, Vec3(10.0, 20.0, 30.0));
  EXPECT_EQ(line.front().arc_length, 0.0);
  // the bend goes along the frame's up, which is x when the direction is z
  EXPECT_LT((line.back().position - Vec3(40.0, 20.0, 80.0)).norm(), 1e-9);
  EXPECT_NEAR(line.back().arc_length, 20.0 + 15.0 * std::numbers::pi, 1e-9);
  for (const CentrelinePoint& point : line) {
    if (point.arc_length < 20.0) continue;
    EXPECT_NEAR((point.position - Vec3(40.0, 20.0, 50.0)).norm(), 30.0, 1e-9);
  }
}

TEST(Tube, ArcLengthIsTheWayAlongTheCentreline) {
  const auto line = tube_centreline(support::s_bend_tube(), 0.5);
  double way = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    way += (line[i].position - line[i - 1].position).norm();
    // chords are shorter than arcs by step^2 / (24 radius^2)
    EXPECT_NEAR(line[i].arc_length, way, 1e-5 * way + 1e-12);
  }
  EXPECT_NEAR(line.back().arc_length, 480.0, 1e-9);
}

TEST(Tube, OppositeBendsRestoreTheDirection) {
  const auto line = tube_centreline(support::s_bend_tube(), 1.0);
  const Vec3 last = line.back().position - line[line.size() - 2].position;
  EXPECT_LT((last.normalized() - Vec3::UnitZ()).norm(), 1e-9);
}

TEST(Tube, PlaneTurnsTheBendAboutTheDirection) {
  TubeDescription tube = quarter_turn();
  tube.legs[1].plane = 90.0_deg;
  // from x towards direction cross x, which is y
  const Vec3 end = tube_centreline(tube, 1.0).back().position;
  EXPECT_LT((end - Vec3(10.0, 50.0, 80.0)).norm(), 1e-9);
}

TEST(Tube, FrameIsCarriedAlongWithoutTwist) {
  // a bend about its own plane keeps the normal of that plane: up, then right, stays in a box
  TubeDescription tube = quarter_turn();
  tube.legs = {{60.0, 90.0_deg, 0.0, 3.0}, {60.0, 90.0_deg, 90.0_deg, 3.0}};
  const double r = 60.0 / (std::numbers::pi / 2.0);
  const Vec3 end = tube_centreline(tube, 1.0).back().position;
  EXPECT_LT((end - (tube.access + Vec3(r, 0, r) + Vec3(r, r, 0))).norm(), 1e-9);
}

TEST(Tube, SurfaceIsOneClosedSphereLikeShell) {
  const TriangleMesh mesh = tube_surface(quarter_turn(), 0.5);
  EXPECT_TRUE(support::every_edge_is_shared_by_two(mesh));
  EXPECT_TRUE(support::every_vertex_has_one_fan(mesh));
  EXPECT_EQ(support::shell_count(mesh), 1);
  EXPECT_EQ(support::euler_characteristic(mesh), 2);
}

TEST(Tube, SurfaceLiesOnTheTubeOfTheDescription) {
  const TriangleMesh mesh = tube_surface(quarter_turn(), 0.5);
  const Vec3 centre(40.0, 20.0, 50.0);
  int on_cylinder = 0, on_torus = 0;
  for (const Vec3& vertex : mesh.vertices) {
    const Vec3 p = vertex - Vec3(10.0, 20.0, 30.0);
    if (p.z() > -kSheathOverhang && p.z() < 19.0) {
      EXPECT_NEAR(std::hypot(p.x(), p.y()), 3.0, 1e-3);
      ++on_cylinder;
    } else if (const Vec3 q = vertex - centre; q.z() > 1.0 && q.x() < -1.0) {
      EXPECT_NEAR(std::hypot(std::hypot(q.x(), q.z()) - 30.0, q.y()), 3.0, 1e-3);
      ++on_torus;
    }
  }
  EXPECT_GT(on_cylinder, 1000);
  EXPECT_GT(on_torus, 1000);
  // cylinder, torus and the two half balls, less what flat facets cut off
  const double length = kSheathOverhang + 20.0 + 15.0 * std::numbers::pi;
  const double volume = std::numbers::pi * 9.0 * length + 4.0 / 3.0 * std::numbers::pi * 27.0;
  EXPECT_NEAR(support::enclosed_volume(mesh), volume, 0.01 * volume);
  EXPECT_LT(support::enclosed_volume(mesh), volume);
}

TEST(Tube, RadiusGoesOverSmoothlyBetweenLegs) {
  TubeDescription tube = quarter_turn();
  tube.legs = {{20.0, 0.0, 0.0, 3.0}, {20.0, 0.0, 0.0, 2.0}, {20.0, 0.0, 0.0, 2.0}};
  for (const CentrelinePoint& point : tube_centreline(tube, 1.0)) {
    const double t = std::clamp((point.arc_length - 20.0) / 20.0, 0.0, 1.0);
    EXPECT_NEAR(point.radius, 3.0 - t * t * (3.0 - 2.0 * t), 1e-9);
  }
}

TEST(Tube, VesselIsReadyForTraining) {
  const Vessel& vessel = support::s_bend_vessel();
  EXPECT_EQ(vessel.access.direction, Vec3::UnitZ());
  EXPECT_NEAR(vessel.access.up.dot(vessel.access.direction), 0.0, 1e-12);
  EXPECT_NEAR(vessel.access.up.norm(), 1.0, 1e-12);
  EXPECT_LE(vessel.display_surface.triangles.size(), kDisplayTriangles);
  EXPECT_GT(vessel.display_surface.triangles.size(), kDisplayTriangles / 2);
  EXPECT_TRUE(support::every_edge_is_shared_by_two(vessel.display_surface));
  // coarser, but the same shape
  for (std::size_t i = 0; i < vessel.display_surface.vertices.size(); i += 10) {
    WallSample sample;
    vessel.wall->sample({&vessel.display_surface.vertices[i], 1}, {&sample, 1});
    EXPECT_NEAR(sample.distance, 0.0, 0.05);
  }
  for (const CentrelinePoint& point : vessel.centreline) {
    WallSample sample;
    vessel.wall->sample({&point.position, 1}, {&sample, 1});
    EXPECT_NEAR(sample.distance, 3.0, 1e-9) << "further from the wall than it looks";
  }
}

TEST(Tube, ImpossibleDescriptionsAreRefused) {
  const auto refused = [](const auto& spoil) {
    TubeDescription tube = quarter_turn();
    spoil(tube);
    EXPECT_THROW(static_cast<void>(tube_centreline(tube, 1.0)), std::invalid_argument);
  };
  refused([](TubeDescription& tube) { tube.legs.clear(); });
  refused([](TubeDescription& tube) { tube.start_radius = 0.0; });
  refused([](TubeDescription& tube) { tube.legs[0].length = -1.0; });
  refused([](TubeDescription& tube) { tube.legs[1].end_radius = NAN; });
  refused([](TubeDescription& tube) { tube.legs[1].plane = INFINITY; });
  refused([](TubeDescription& tube) { tube.legs[1].length = 4.0; });  // bends inside its lumen
  refused([](TubeDescription& tube) { tube.direction.setZero(); });
  EXPECT_THROW(static_cast<void>(tube_surface(quarter_turn(), 1.6)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(tube_surface(quarter_turn(), 0.0)), std::invalid_argument);
}

}  // namespace
}  // namespace sim
