#include "sim/dynamics/world.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sim/base/units.h"
#include "tests/support/allocation_count.h"
#include "tests/support/random_commands.h"
#include "tests/support/vessels.h"

namespace sim {
namespace {

using namespace base::units;

constexpr double kLength = 200.0, kRadius = 4.0;

// The rod gives way along itself: 1 N over 200 mm at EA = 10 kN. Pushes here are far below 1 N.
constexpr double kStretch = 1e-3;  // mm

// The inside of a straight tube along z, by its formula.
class StraightWall final : public Wall {
 public:
  void sample(std::span<const Vec3> points, std::span<WallSample> samples) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 across(points[i].x(), points[i].y(), 0.0);
      const double radius = across.norm();
      samples[i] = {kRadius - radius, radius > 1e-9 ? Vec3(-across / radius) : Vec3::UnitX()};
    }
  }
};

// A wall that has lost its mind.
class BrokenWall final : public Wall {
 public:
  void sample(std::span<const Vec3> points, std::span<WallSample> samples) const override {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < points.size(); ++i) {
      samples[i] = {points[i].z() > 50.0 ? nan : kRadius, Vec3::UnitX()};
    }
  }
};

template <typename SomeWall>
Vessel straight_vessel() {
  Vessel vessel;
  vessel.id = "straight";
  for (int i = 0; i <= 20; ++i) {
    vessel.centreline.push_back({Vec3(0.0, 0.0, 10.0 * i), kRadius, 10.0 * i});
  }
  vessel.wall = std::make_unique<SomeWall>();
  return vessel;
}

std::vector<std::byte> state_of(const World& world) {
  std::vector<std::byte> bytes;
  world.append_state(bytes);
  return bytes;
}

void steer(World& world, const HandleInput& input, int steps) {
  for (int i = 0; i < steps; ++i) ASSERT_EQ(world.step(input), StepStatus::ok);
}

TEST(World, StartsWithTheHandleAtZeroAndTheInstrumentWhereTheTrialWantsIt) {
  const Vessel vessel = straight_vessel<StraightWall>();
  const Instrument wire = support::straight_guidewire();
  World world({&vessel, &wire, 120.0});
  const Observation& seen = world.observation();
  EXPECT_EQ(seen.step, 0);
  EXPECT_EQ(seen.handle_axial, 0.0);
  EXPECT_EQ(seen.handle_rotation, 0.0);
  EXPECT_NEAR(seen.inserted_length, 120.0, kStretch);
  EXPECT_LT((seen.tip - Vec3(0.0, 0.0, 120.0)).norm(), 1e-3);  // straight, touching nothing
  steer(world, {20.0, 0.0}, 1000);
  EXPECT_NEAR(seen.handle_axial, 20.0, 1e-9);
  EXPECT_NEAR(seen.inserted_length, 140.0, kStretch);
  EXPECT_EQ(seen.step, 1000);
}

TEST(World, StopsTheHandleWhereTheInstrumentIsOut) {
  const Vessel vessel = straight_vessel<StraightWall>();
  const Instrument wire = support::straight_guidewire();
  World world({&vessel, &wire, 20.0});
  steer(world, {-60.0, 0.0}, 1000);
  EXPECT_NEAR(world.observation().inserted_length, 0.0, kStretch);
  EXPECT_NEAR(world.observation().handle_axial, -20.0, 1e-9);
  steer(world, {30.0, 0.0}, 1000);  // and it moves again at once
  EXPECT_NEAR(world.observation().inserted_length, 30.0, kStretch);
}

TEST(World, StopsTheHandleWhereTheVesselEnds) {
  const Vessel vessel = straight_vessel<StraightWall>();
  const Instrument wire = support::straight_guidewire();
  World world({&vessel, &wire, 180.0});
  steer(world, {60.0, 0.0}, 1000);
  EXPECT_NEAR(world.observation().inserted_length, kLength, kStretch);
}

TEST(World, StopsTheHandleWhereTheInstrumentEnds) {
  const Vessel vessel = straight_vessel<StraightWall>();
  Instrument wire = support::straight_guidewire();
  wire.sections = {{60.0, 50.0, 40.0}, {60.0, 291.0, 223.8}};
  wire.length = 120.0;
  World world({&vessel, &wire, 100.0});
  steer(world, {60.0, 0.0}, 1000);
  EXPECT_NEAR(world.observation().inserted_length, 120.0, kStretch);
}

TEST(World, TurnsTheTipClockwiseSeenByTheOperator) {
  const Vessel vessel = straight_vessel<StraightWall>();
  const Instrument wire = support::angled_guidewire();
  World world({&vessel, &wire, 60.0});
  const auto angle_of_tip = [&] {
    const Vec3 direction = world.observation().tip_direction;
    return std::atan2(direction.y(),
                      direction.x());  // about z, which points away from the operator
  };
  const double before = angle_of_tip();
  steer(world, {0.0, 90.0_deg}, 1000);
  steer(world, {0.0, 0.0}, 500);
  const double turned = std::remainder(angle_of_tip() - before, 2.0 * std::numbers::pi);
  // friction at the tip holds back a few degrees of twist
  EXPECT_NEAR(turned, 90.0_deg, 10.0_deg);
  EXPECT_NEAR(world.observation().handle_rotation, 90.0_deg, 1e-9);
}

TEST(World, SameInputsGiveTheSameStateToTheLastBit) {
  const Vessel vessel = straight_vessel<StraightWall>();
  const Instrument wire = support::angled_guidewire();
  World one({&vessel, &wire, 50.0}), same({&vessel, &wire, 50.0}), other({&vessel, &wire, 50.0});
  EXPECT_EQ(state_of(one), state_of(same));
  support::run_random_commands(one, vessel, wire, 10, 1);
  support::run_random_commands(same, vessel, wire, 10, 1);
  support::run_random_commands(other, vessel, wire, 10, 2);
  EXPECT_EQ(state_of(one), state_of(same));
  EXPECT_NE(state_of(one), state_of(other));
}

TEST(World, SaysWhenItDivergesAndStaysAsItIs) {
  const Vessel vessel = straight_vessel<BrokenWall>();
  const Instrument wire = support::straight_guidewire();
  World world({&vessel, &wire, 45.0});
  StepStatus status = StepStatus::ok;
  Observation before;
  for (int i = 0; i < 1000 && status == StepStatus::ok; ++i) {
    before = world.observation();
    status = world.step({30.0, 0.0});
  }
  EXPECT_EQ(status, StepStatus::diverged);
  EXPECT_EQ(world.observation().step, before.step);
  EXPECT_TRUE(world.observation().tip.allFinite());
}

TEST(World, StepAllocatesNothing) {
  const Vessel vessel = straight_vessel<StraightWall>();
  const Instrument wire = support::angled_guidewire();
  World world({&vessel, &wire, 50.0});
  const long before = support::allocation_count();
  for (int i = 0; i < 2000; ++i) {  // growing, turning, in contact, shrinking
    const double feed = i < 1200 ? 80.0 : -80.0;
    if (world.step({feed, 180.0_deg}) != StepStatus::ok) break;
  }
  EXPECT_EQ(support::allocation_count() - before, 0);
  EXPECT_EQ(world.observation().step, 2000);
}

TEST(World, TimesEachPhase) {
  const Vessel vessel = straight_vessel<StraightWall>();
  const Instrument wire = support::straight_guidewire();
  World world({&vessel, &wire, 50.0});
  ASSERT_EQ(world.step({}), StepStatus::ok);
  const StepProfile& profile = world.profile();
  EXPECT_GT(profile.find_contacts, 0.0);
  EXPECT_GT(profile.solve_instrument, 0.0);
  EXPECT_GE(profile.rigid_bodies, 0.0);
  EXPECT_GE(profile.observe, 0.0);
}

TEST(World, RefusesAScenarioThatIsIncompleteOrImpossible) {
  const Vessel vessel = straight_vessel<StraightWall>();
  const Instrument wire = support::straight_guidewire();
  EXPECT_THROW(World({nullptr, &wire, 0.0}), std::invalid_argument);
  EXPECT_THROW(World({&vessel, nullptr, 0.0}), std::invalid_argument);
  EXPECT_THROW(World({&vessel, &wire, -1.0}), std::invalid_argument);
  EXPECT_THROW(World({&vessel, &wire, NAN}), std::invalid_argument);
  EXPECT_THROW(World({&vessel, &wire, kLength + 1.0}), std::invalid_argument);
  Vessel without_wall = straight_vessel<StraightWall>();
  without_wall.wall.reset();
  EXPECT_THROW(World({&without_wall, &wire, 0.0}), std::invalid_argument);
}

// The linear task's way through the real vessel: 0 -> 350 -> 150 -> 350 mm at 30 mm/s.
TEST(World, FeedsThroughTheSBendAndBackWithMeasurableForce) {
  const Instrument wire = support::straight_guidewire();
  World world({&support::s_bend_vessel(), &wire, 0.0});
  std::vector<double> forces;
  double largest_jump = 0.0, before = 0.0;
  long unconverged = 0;
  for (const double target : {350.0, 150.0, 350.0}) {
    const double way = target - world.observation().handle_axial;
    const int steps = static_cast<int>(std::lround(std::abs(way) / 30.0e-3));
    for (int i = 0; i < steps; ++i) {
      ASSERT_EQ(world.step({way / (steps * kStepLength), 0.0}), StepStatus::ok);
      const Observation& seen = world.observation();
      forces.push_back(seen.contact_force);
      unconverged += seen.solver_residual > 5.0_mN;
      if (i > 20) largest_jump = std::max(largest_jump, std::abs(seen.handle_force - before));
      before = seen.handle_force;
    }
    EXPECT_NEAR(world.observation().handle_axial, target, 1e-6);
  }
  std::sort(forces.begin(), forces.end());
  const double p95 = forces[forces.size() * 95 / 100];
  EXPECT_GT(p95, 0.05);
  EXPECT_LT(forces.back(), 2.0);
  EXPECT_LT(static_cast<double>(unconverged), 0.001 * static_cast<double>(forces.size()));
  EXPECT_LT(largest_jump, 15.0_mN);  // per ms, once the reversal is over
  std::printf("contact force p95 %.3f max %.3f N, handle force jump %.1f mN/ms, %ld unconverged\n",
              p95, forces.back(), largest_jump * 1e3, unconverged);
}

// Nothing ever leaves the lumen, whatever the hand does.
TEST(World, KeepsEveryInstrumentInsideTheWall) {
  const Vessel& vessel = support::s_bend_vessel();
  std::uint32_t seed = 17;
  for (const Instrument& wire : {support::straight_guidewire(), support::angled_guidewire()}) {
    World world({&vessel, &wire, 200.0});
    const auto report = support::run_random_commands(world, vessel, wire, 60, seed++);
    std::printf(
        "%s: %lld steps, inserted %.0f to %.0f mm, deepest %.3f mm, force max %.2f p99 %.2f"
        " N, handle %.2f N, %lld unconverged, %lld in contact\n",
        wire.id.c_str(), static_cast<long long>(report.steps), report.inserted_min,
        report.inserted_max, report.deepest, report.force_max, report.force_p99,
        report.handle_force_max, static_cast<long long>(report.unconverged),
        static_cast<long long>(report.in_contact));
    EXPECT_FALSE(report.diverged);
    EXPECT_TRUE(report.finite);
    EXPECT_EQ(report.commands, 60);
    EXPECT_LT(report.deepest, 0.3);
    EXPECT_LT(report.force_max, 2.0);  // the shaft buckles before it can push harder
    EXPECT_LE(static_cast<double>(report.unconverged), 0.001 * static_cast<double>(report.steps));
  }
}

}  // namespace
}  // namespace sim
