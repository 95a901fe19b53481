#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "sim/anatomy/cell_cases.h"
#include "sim/anatomy/marching_cubes.h"
#include "tests/support/surface.h"

namespace sim {
namespace {

using support::euler_characteristic;
using support::every_edge_is_shared_by_two;
using support::every_vertex_has_one_fan;
using support::winding_number;

// A volume held in memory, the slowest way and therefore the clearest.
struct Volume {
  VolumeShape shape;
  std::vector<float> values;

  Volume(std::array<int, 3> size, Vec3 origin, Vec3 spacing) : shape{size, origin, spacing} {
    values.resize(static_cast<std::size_t>(size[0] * size[1] * size[2]));
  }
  std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>((z * shape.size[1] + y) * shape.size[0] + x);
  }
  Vec3 position(int x, int y, int z) const {
    return shape.origin + Vec3(x, y, z).cwiseProduct(shape.spacing);
  }
  template <typename Function>
  void fill(const Function& function) {
    for (int z = 0; z < shape.size[2]; ++z) {
      for (int y = 0; y < shape.size[1]; ++y) {
        for (int x = 0; x < shape.size[0]; ++x) {
          values[index(x, y, z)] = static_cast<float>(function(position(x, y, z)));
        }
      }
    }
  }
  TriangleMesh surface(float threshold = 0.0F) const {
    const SliceSource slice = [this](int z, std::span<float> target) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(index(0, 0, z));
      std::copy(first, first + static_cast<std::ptrdiff_t>(target.size()), target.begin());
    };
    return marching_cubes(shape, slice, threshold);
  }
};

TEST(MarchingCubes, EveryRandomVolumeGivesAClosedManifold) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> noise(-1.0F, 1.0F);
  std::uniform_int_distribution<int> side(1, 7);
  for (int i = 0; i < 400; ++i) {
    Volume volume({side(random), side(random), side(random)}, Vec3::Zero(), Vec3::Ones());
    // from nearly empty to nearly full: noise of both signs has every ambiguous cell
    const float shift = -0.8F + 1.6F * static_cast<float>(i) / 400.0F;
    for (float& value : volume.values) value = noise(random) + shift;
    const TriangleMesh mesh = volume.surface();
    if (mesh.triangles.empty()) continue;
    ASSERT_TRUE(every_edge_is_shared_by_two(mesh)) << "volume " << i;
    ASSERT_TRUE(every_vertex_has_one_fan(mesh)) << "volume " << i;
    ASSERT_EQ(euler_characteristic(mesh) % 2, 0) << "volume " << i;
    ASSERT_EQ(mesh.normals.size(), mesh.vertices.size());
  }
}

TEST(MarchingCubes, VolumesOfZerosAndOnesHaveEveryCellConfigurationAndStayClosed) {
  // exact ties and plateaus: what a segmentation mask looks like
  std::mt19937 random(6);
  std::bernoulli_distribution coin(0.5);
  Volume volume({24, 24, 24}, Vec3::Zero(), Vec3::Ones());
  for (float& value : volume.values) value = coin(random) ? 1.0F : 0.0F;
  const TriangleMesh mesh = volume.surface(0.5F);
  EXPECT_TRUE(every_edge_is_shared_by_two(mesh));
  EXPECT_TRUE(every_vertex_has_one_fan(mesh));
  std::set<int> masks;
  for (int z = 0; z + 1 < 24; ++z) {
    for (int y = 0; y + 1 < 24; ++y) {
      for (int x = 0; x + 1 < 24; ++x) {
        int mask = 0;
        for (int c = 0; c < 8; ++c) {
          if (volume.values[volume.index(x + (c & 1), y + ((c >> 1) & 1), z + (c >> 2))] > 0.5F) {
            mask |= 1 << c;
          }
        }
        masks.insert(mask);
      }
    }
  }
  EXPECT_EQ(masks.size(), 256U) << "the volume was meant to show every cell";
}

TEST(MarchingCubes, SeparatesInsideFromOutside) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> noise(-1.0F, 1.0F);
  Volume volume({6, 5, 7}, Vec3(1.0, -2.0, 3.0), Vec3(0.5, 0.7, 1.1));
  for (float& value : volume.values) value = noise(random);
  const TriangleMesh mesh = volume.surface();
  for (int z = 0; z < 7; ++z) {
    for (int y = 0; y < 5; ++y) {
      for (int x = 0; x < 6; ++x) {
        const double expected = volume.values[volume.index(x, y, z)] > 0.0F ? 1.0 : 0.0;
        EXPECT_NEAR(winding_number(mesh, volume.position(x, y, z)), expected, 1e-6);
      }
    }
  }
}

TEST(MarchingCubes, SphereHasItsTopologyItsPlaceAndItsNormals) {
  const Vec3 centre(3.0, -1.0, 2.0);
  Volume volume({30, 28, 32}, centre - Vec3(7.2, 6.9, 7.6), Vec3::Constant(0.5));
  volume.fill([&](const Vec3& p) { return 5.0 - (p - centre).norm(); });
  const TriangleMesh mesh = volume.surface();
  EXPECT_EQ(euler_characteristic(mesh), 2);
  EXPECT_EQ(support::shell_count(mesh), 1);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3 out = mesh.vertices[i] - centre;
    // the cubic along the edge is off by about spacing^4 / radius^3
    EXPECT_NEAR(out.norm(), 5.0, 1e-3);
    // central differences: spacing^2 / (6 radius^2), 0.1 degrees
    EXPECT_GT(mesh.normals[i].dot(out.normalized()), std::cos(0.25 * std::numbers::pi / 180.0));
  }
  // facets cut off: spacing^2 / radius^2 of the volume
  EXPECT_NEAR(support::enclosed_volume(mesh), 4.0 / 3.0 * std::numbers::pi * 125.0, 5.0);
}

TEST(MarchingCubes, TorusHasAHole) {
  Volume volume({40, 40, 16}, Vec3(-9.9, -9.8, -3.7), Vec3::Constant(0.5));
  volume.fill(
      [](const Vec3& p) { return 2.0 - std::hypot(std::hypot(p.x(), p.y()) - 6.0, p.z()); });
  const TriangleMesh mesh = volume.surface();
  EXPECT_EQ(euler_characteristic(mesh), 0);
  EXPECT_TRUE(every_edge_is_shared_by_two(mesh));
}

TEST(MarchingCubes, TwoBallsAreTwoShells) {
  Volume volume({30, 14, 14}, Vec3(-7.3, -3.4, -3.3), Vec3::Constant(0.5));
  volume.fill([](const Vec3& p) {
    return 2.0 - std::min((p - Vec3(-4, 0, 0)).norm(), (p - Vec3(4, 0, 0)).norm());
  });
  const TriangleMesh mesh = volume.surface();
  EXPECT_EQ(support::shell_count(mesh), 2);
  EXPECT_EQ(euler_characteristic(mesh), 4);
}

TEST(MarchingCubes, ClosesWhatReachesTheBorder) {
  Volume volume({4, 4, 4}, Vec3::Zero(), Vec3::Ones());
  volume.fill([](const Vec3&) { return 1.0; });
  const TriangleMesh mesh = volume.surface();
  EXPECT_TRUE(every_edge_is_shared_by_two(mesh));
  EXPECT_EQ(euler_characteristic(mesh), 2);
  EXPECT_GT(support::enclosed_volume(mesh), 27.0);  // at least from centre to centre
}

TEST(MarchingCubes, NothingInsideIsNoSurface) {
  Volume volume({3, 3, 3}, Vec3::Zero(), Vec3::Ones());
  volume.fill([](const Vec3&) { return -1.0; });
  EXPECT_TRUE(volume.surface().triangles.empty());
}

TEST(MarchingCubes, RefusesWhatIsNoVolume) {
  Volume volume({3, 3, 3}, Vec3::Zero(), Vec3::Ones());
  volume.values[13] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(volume.surface()), std::invalid_argument);
  volume.values[13] = 0.0F;
  volume.shape.size = {3, 0, 3};
  EXPECT_THROW(static_cast<void>(volume.surface()), std::invalid_argument);
  volume.shape.size = {3, 3, 3};
  volume.shape.spacing.y() = 0.0;
  EXPECT_THROW(static_cast<void>(volume.surface()), std::invalid_argument);
}

TEST(CellCases, EachCrossedEdgeIsUsedAndNoOther) {
  for (std::size_t mask = 0; mask < 256; ++mask) {
    std::set<int> used, crossed;
    for (const auto& triangle : cell_cases()[mask]) used.insert(triangle.begin(), triangle.end());
    for (int e = 0; e < 12; ++e) {
      const CellEdge& edge = cell_edges()[static_cast<std::size_t>(e)];
      if (((mask >> edge.from) & 1) != ((mask >> edge.to) & 1)) crossed.insert(e);
    }
    EXPECT_EQ(used, crossed) << "mask " << mask;
  }
}

}  // namespace
}  // namespace sim
