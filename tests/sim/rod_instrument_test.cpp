// The rod as an instrument: fed through the sheath, held, turned, withdrawn.
#include "sim/dynamics/rod_instrument.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "sim/dynamics/rod_contact_force.h"
#include "tests/support/rod_scenes.h"

namespace sim {
namespace {

RodSettings element_length(double length) {
  RodSettings settings;
  settings.element_length = length;
  settings.tip_element_length = length;
  return settings;
}

// A straight stretch, one bend, a straight stretch, from the access along +z.
TubeWall bent_tube(double straight, double bend_radius, double angle, double radius = 3.0) {
  TubeWall tube(radius, Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX());
  if (straight > 0.0) tube.add_straight(straight);
  tube.add_bend(bend_radius, angle);
  tube.add_straight(500.0);
  return tube;
}

// Moves the handle steadily; returns false when the rod fails.
struct Handle {
  RodInstrument& rod;
  double axial = 0.0;
  double rotation = 0.0;

  bool move(double feed_per_step, double turn_per_step) {
    axial += feed_per_step;
    rotation += turn_per_step;
    return rod.step(axial, rotation) == RodStatus::ok;
  }
};

TEST(RodInstrument, MaterialIsNeitherMadeNorLost) {
  const Instrument wire = scenes::stiff_wire(400.0, 0.1);
  RodInstrument rod(wire, Access{}, nullptr, 5.0);
  EXPECT_NEAR(rod.inserted_length(), 5.0, 1e-6);
  Handle handle{rod};
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(handle.move(0.05, 0.0));
  // nothing resists in free space, so nothing is compressed
  EXPECT_NEAR(rod.inserted_length(), 55.0, 1e-3);
  EXPECT_NEAR(rod.tip().z(), 55.0, 1e-2);
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(handle.move(-0.05, 0.0));
  EXPECT_NEAR(rod.inserted_length(), 5.0, 1e-3);
  const auto nodes = rod.nodes();
  EXPECT_LE(nodes[rod.first_visible()].z(), 1e-9);
  EXPECT_GT(nodes[rod.first_visible() + 1].z(), 0.0);
}

TEST(RodInstrument, WholeInstrumentCanBeInserted) {
  RodInstrument rod(scenes::uniform_wire(120.0, 500.0, 0.1), Access{}, nullptr, 0.0);
  Handle handle{rod};
  for (int i = 0; i < 1200; ++i) ASSERT_TRUE(handle.move(0.1, 0.0));
  EXPECT_NEAR(rod.inserted_length(), 120.0, 1e-3);
  for (int i = 0; i < 1200; ++i) ASSERT_TRUE(handle.move(-0.1, 0.0));
  EXPECT_NEAR(rod.inserted_length(), 0.0, 1e-3);
}

TEST(RodInstrument, TurningTheHandleClockwiseTurnsTheBentTip) {
  Instrument wire = scenes::uniform_wire(300.0, 40.0, 0.0);
  wire.tip_bends = {{0.0, 12.0, 0.06}};
  RodInstrument rod(wire, Access{}, nullptr, 40.0);
  // a positive bend points up, here +x, and no lateral force bends it elsewhere
  EXPECT_GT(rod.tip().x(), 2.0);
  EXPECT_NEAR(rod.tip().y(), 0.0, 1e-6);
  Handle handle{rod};
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(handle.move(0.0, 0.5e-3 * scenes::kPi));
  for (int i = 0; i < 500; ++i) ASSERT_TRUE(handle.move(0.0, 0.0));
  // a quarter turn about +z takes +x to +y; clockwise for the operator who looks along +z
  EXPECT_GT(rod.tip().y(), 2.0);
  EXPECT_NEAR(rod.tip().x(), 0.0, 0.02);
}

TEST(RodInstrument, FeedingIsSmoothFromTheFirstMillimetres) {
  const TubeWall tube = bent_tube(30.0, 30.0, 1.5);
  RodInstrument rod(scenes::stiff_wire(400.0, 0.15), Access{}, &tube, 5.0);
  Handle handle{rod};
  double before = rod.handle_force();
  double largest = 0.0;
  for (int i = 0; i < 4000; ++i) {
    ASSERT_TRUE(handle.move(0.03, 0.0));
    if (i > 30) largest = std::max(largest, std::abs(rod.handle_force() - before));
    before = rod.handle_force();
  }
  EXPECT_GT(rod.contact_count(), 4);
  EXPECT_LT(largest, 0.015);  // N per ms at 30 mm/s: what a hand must not feel
}

TEST(RodInstrument, HeldWireDoesNotCreep) {
  const TubeWall tube = bent_tube(20.0, 30.0, 1.5);
  RodInstrument rod(scenes::stiff_wire(400.0, 0.15), Access{}, &tube, 5.0);
  Handle handle{rod};
  for (int i = 0; i < 3000; ++i) ASSERT_TRUE(handle.move(0.03, 0.5e-3));
  for (int i = 0; i < 300; ++i) ASSERT_TRUE(handle.move(0.0, 0.0));
  const double force = rod.handle_force();
  const Vec3 tip = rod.tip();
  EXPECT_GT(std::abs(force), 0.02);
  for (int i = 0; i < 5000; ++i) ASSERT_TRUE(handle.move(0.0, 0.0));
  EXPECT_NEAR(rod.handle_force(), force, 1e-3);
  EXPECT_LT((rod.tip() - tip).norm(), 0.01);
}

TEST(RodInstrument, PushIntoABendCostsItsElasticEnergy) {
  // energy balance: every mm pushed into the bend stores EI / (2 R^2)
  constexpr double kStiffness = 1000.0;
  constexpr double kRadius = 50.0;
  const TubeWall tube = bent_tube(40.0, kRadius, 3.0, 0.6);
  RodInstrument rod(scenes::uniform_wire(400.0, kStiffness, 0.0), Access{}, &tube, 5.0);
  Handle handle{rod};
  while (rod.inserted_length() < 110.0) ASSERT_TRUE(handle.move(0.01, 0.0));
  double sum = 0.0;
  int count = 0;
  while (rod.inserted_length() < 150.0) {
    ASSERT_TRUE(handle.move(0.01, 0.0));
    sum += rod.handle_force();
    ++count;
  }
  // the clearance of 0.16 mm and the wall's give widen the bend a little; drag is below 1 mN
  EXPECT_NEAR(sum / count, kStiffness / (2.0 * kRadius * kRadius), 0.02);
}

TEST(RodInstrument, ContactForceDoesNotDependOnTheMesh) {
  double mean[2] = {};
  for (int fine = 0; fine < 2; ++fine) {
    const TubeWall tube = bent_tube(30.0, 30.0, 1.5);
    RodInstrument rod(scenes::stiff_wire(400.0, 0.15), Access{}, &tube, 5.0,
                      element_length(fine == 0 ? 4.0 : 2.0));
    Handle handle{rod};
    for (int i = 0; i < 4000; ++i) {
      ASSERT_TRUE(handle.move(0.03, 0.0));
      mean[fine] += rod.contact_force() / 4000.0;
    }
  }
  EXPECT_GT(mean[1], 0.1);
  EXPECT_NEAR(mean[0], mean[1], 0.05 * mean[1]);
}

TEST(RodInstrument, HandleForceDoesNotDependOnTheMesh) {
  double mean[2] = {};
  for (int fine = 0; fine < 2; ++fine) {
    const TubeWall tube = bent_tube(30.0, 30.0, 1.5);
    RodInstrument rod(scenes::uniform_wire(400.0, 500.0, 0.15), Access{}, &tube, 5.0,
                      element_length(fine == 0 ? 3.0 : 1.0));
    Handle handle{rod};
    for (int i = 0; i < 4500; ++i) {
      ASSERT_TRUE(handle.move(0.03, 0.0));
      if (i >= 3500) mean[fine] += rod.handle_force() / 1000.0;
    }
  }
  EXPECT_NEAR(mean[0], mean[1], 0.01 * mean[1]);
}

TEST(RodInstrument, TorqueOfATurningWireIsItsFriction) {
  // turned steadily, every contact slips around the wire: torque = mu r (sum of normal forces)
  constexpr double kFriction = 0.15;
  const TubeWall tube = bent_tube(30.0, 30.0, 1.5);
  const Instrument wire = scenes::uniform_wire(400.0, 500.0, kFriction);
  RodInstrument rod(wire, Access{}, &tube, 5.0);
  Handle handle{rod};
  for (int i = 0; i < 4000; ++i) ASSERT_TRUE(handle.move(0.03, 0.0));
  for (int i = 0; i < 2000; ++i) ASSERT_TRUE(handle.move(0.0, 2e-3));
  double torque = 0.0;
  double load = 0.0;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(handle.move(0.0, 2e-3));
    torque += rod.handle_torque();
    load += rod.contact_load();
  }
  // the rest is the drag of turning, 3e-5 N mm
  EXPECT_NEAR(torque, kFriction * 0.5 * wire.outer_diameter * load, 0.005 * torque);
}

TEST(RodInstrument, BlockedTipStaysInside) {
  // a wall across the tube, against which the tip is pressed with more than a hand's force
  class ClosedTube final : public Wall {
   public:
    explicit ClosedTube(double end)
        : tube_(bent_tube(400.0, 30.0, 0.1)), end_(Vec3(0.0, 0.0, end), -Vec3::UnitZ()) {}
    void sample(std::span<const Vec3> points, std::span<WallSample> samples) const override {
      tube_.sample(points, samples);
      for (std::size_t i = 0; i < points.size(); ++i) {
        WallSample end;
        end_.sample({&points[i], 1}, {&end, 1});
        if (end.distance < samples[i].distance) samples[i] = end;
      }
    }

   private:
    TubeWall tube_;
    PlaneWall end_;
  };
  const ClosedTube wall(60.0);
  RodInstrument rod(scenes::stiff_wire(400.0, 0.1), Access{}, &wall, 50.0);
  Handle handle{rod};
  for (int i = 0; i < 520; ++i) ASSERT_TRUE(handle.move(0.02, 0.0));
  EXPECT_GT(rod.handle_force(), 5.0);
  EXPECT_LT(rod.tip().z(), 60.5);
  for (int i = 0; i < 1500; ++i) ASSERT_TRUE(handle.move(-0.02, 0.0));
  EXPECT_LT(rod.contact_force(), 0.1);
}

TEST(RodInstrument, FrictionMakesPushingHarder) {
  double force[2] = {};
  for (int rough = 0; rough < 2; ++rough) {
    const TubeWall tube = bent_tube(30.0, 30.0, 1.5);
    RodInstrument rod(scenes::stiff_wire(400.0, rough == 0 ? 0.04 : 0.3), Access{}, &tube, 5.0);
    Handle handle{rod};
    for (int i = 0; i < 4000; ++i) ASSERT_TRUE(handle.move(0.03, 0.0));
    force[rough] = rod.handle_force();
  }
  EXPECT_GT(force[1], 1.2 * force[0]);
}

TEST(RodInstrument, RejectsWhatCannotBe) {
  const Instrument wire = scenes::stiff_wire(400.0, 0.1);
  EXPECT_THROW(RodInstrument(wire, Access{}, nullptr, -1.0), std::invalid_argument);
  EXPECT_THROW(RodInstrument(wire, Access{}, nullptr, 401.0), std::invalid_argument);
  Access slanted;
  slanted.up = Vec3(0.0, 0.6, 0.8);
  EXPECT_THROW(RodInstrument(wire, slanted, nullptr, 5.0), std::invalid_argument);
  EXPECT_THROW(RodInstrument(Instrument{}, Access{}, nullptr, 0.0), std::invalid_argument);
  const std::vector<Vec3> short_path = {Vec3::Zero(), Vec3(0.0, 0.0, 10.0)};
  EXPECT_THROW(RodInstrument(wire, Access{}, nullptr, 20.0, {}, short_path), std::invalid_argument);
}

TEST(RodContactForce, IsTheLargestSumOverSixMillimetres) {
  // one newton on every 2 mm: 6 mm carry three of them, wherever they lie
  const std::vector<Vec3> even(10, Vec3(1.0, 0.0, 0.0));
  EXPECT_NEAR(largest_contact_force(even, std::vector<double>(10, 2.0)), 3.0, 1e-12);
  // the same load on 4 mm cells
  const std::vector<Vec3> coarse(5, Vec3(2.0, 0.0, 0.0));
  EXPECT_NEAR(largest_contact_force(coarse, std::vector<double>(5, 4.0)), 3.0, 1e-12);
  // at a point: all of it, on any mesh
  std::vector<Vec3> single(9, Vec3::Zero());
  single[4] = Vec3(0.0, 2.0, 0.0);
  EXPECT_NEAR(largest_contact_force(single, std::vector<double>(9, 4.0)), 2.0, 1e-12);
  EXPECT_NEAR(largest_contact_force(single, std::vector<double>(9, 1.0)), 2.0, 1e-12);
  // opposite walls cancel within a short rod, but each half alone counts
  EXPECT_NEAR(largest_contact_force(std::vector<Vec3>{Vec3::UnitX(), -Vec3::UnitX()},
                                    std::vector<double>{1.0, 1.0}),
              1.0, 1e-12);
  EXPECT_EQ(largest_contact_force({}, {}), 0.0);
}

TEST(RodContactForce, AgreesWithForcesSpreadEvenlyOverTheirCells) {
  std::vector<Vec3> forces;
  std::vector<double> cells;
  for (int i = 0; i < 40; ++i) {
    forces.emplace_back(1.0 + std::sin(0.3 * i), std::cos(0.4 * i), std::sin(0.4 * i));
    cells.push_back(1.0 + 0.5 * std::sin(3.0 * i) + (i % 7 == 0 ? 3.0 : 0.0));
  }
  double total = 0.0;
  for (double cell : cells) total += cell;
  double largest = 0.0;
  for (double from = -6.0; from < total; from += 1e-3) {
    Vec3 sum = Vec3::Zero();
    double start = 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double common =
          std::min(from + kContactWindow, start + cells[i]) - std::max(from, start);
      if (common > 0.0) sum += common / cells[i] * forces[i];
      start += cells[i];
    }
    largest = std::max(largest, sum.norm());
  }
  // two ways of spreading a node's force within its cell: they agree to a part of one node's
  EXPECT_NEAR(largest_contact_force(forces, cells), largest, 0.1 * largest);
}

}  // namespace
}  // namespace sim
