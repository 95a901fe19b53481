// The rod's step: what is known of a free rod, and whether Newton's matrix belongs to its residual.
#include "sim/dynamics/rod_solver.h"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "sim/validation/analytic_walls.h"
#include "tests/support/rod_scenes.h"

namespace sim {
namespace {

RodMesh uniform_mesh(double length, double element, double stiffness, double friction) {
  return make_rod_mesh(scenes::uniform_wire(length, stiffness, friction),
                       {.element_length = element, .tip_element_length = element});
}

std::vector<Vec3> line_of_nodes(const RodMesh& mesh) {
  std::vector<Vec3> nodes;
  for (double arc : mesh.arc) nodes.emplace_back(arc, 0.0, 0.0);
  return nodes;
}

TEST(RodBand, SolvesLikeADenseSolver) {
  constexpr std::size_t kNodes = 9;
  constexpr std::size_t kSize = 4 * kNodes - 1;
  RodBand band(kNodes);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(kSize, kSize);
  Eigen::VectorXd right_side(kSize);
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t j = 0; j < kSize; ++j) {
      // the shape that rods have: three positions and a twist per node, two nodes either side,
      // a twist not coupled further than to the nodes of its own two cells
      const std::size_t low = std::min(i, j);
      const std::size_t high = std::max(i, j);
      const std::size_t reach = low % 4 == 3 ? low + 7 : 4 * (low / 4) + 10;
      if (high > reach) continue;
      const auto a = static_cast<double>(i);
      const auto b = static_cast<double>(j);
      const double value = i == j ? 9.0 : std::sin(3.1 * a + 1.7 * b);
      band.at(i, j) = value;
      dense(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = value;
    }
    right_side[static_cast<Eigen::Index>(i)] = std::cos(static_cast<double>(i));
  }
  std::vector<double> solution(kSize + RodBand::kReach);
  for (std::size_t i = 0; i < kSize; ++i) {
    solution[i] = right_side[static_cast<Eigen::Index>(i)];
  }
  band.solve(kSize, solution.data());
  const Eigen::VectorXd exact = dense.partialPivLu().solve(right_side);
  for (std::size_t i = 0; i < kSize; ++i) {
    EXPECT_NEAR(solution[i], exact[static_cast<Eigen::Index>(i)], 1e-12);
  }
}

TEST(RodSolver, FreeRodKeepsItsMomentum) {
  const RodMesh mesh = uniform_mesh(40.0, 2.0, 50.0, 0.0);
  RodSettings settings;
  settings.drag = 0.0;
  settings.tolerance = 1e-12;
  settings.max_iterations = 30;
  RodSolver solver(mesh, settings, nullptr);
  solver.place(line_of_nodes(mesh), Vec3::UnitZ());
  // set in motion by a force on one node for ten steps: an impulse of 10 ms times 0.01 N
  solver.set_load(4, Vec3(0.0, 0.01, 0.002));
  for (int i = 0; i < 10; ++i) ASSERT_EQ(solver.step(), RodStatus::ok);
  solver.set_load(4, Vec3::Zero());
  for (int i = 0; i < 200; ++i) {
    ASSERT_EQ(solver.step(), RodStatus::ok);
    Vec3 momentum = Vec3::Zero();
    for (std::size_t k = 0; k < mesh.node_count(); ++k) {
      momentum += settings.line_density * mesh.cell_length[k] * solver.state().velocity[k];
    }
    // 21 nodes left unbalanced by up to 1e-12 N for 200 ms
    EXPECT_LT((momentum - Vec3(0.0, 1e-4, 2e-5)).norm(), 1e-11);
  }
}

TEST(RodSolver, RestingBentRodGainsNoEnergy) {
  Instrument wire = scenes::uniform_wire(60.0, 30.0, 0.0);
  wire.tip_bends = {{0.0, 20.0, 0.08}};
  const RodMesh mesh = make_rod_mesh(wire, {.element_length = 2.0, .tip_element_length = 2.0});
  RodSettings settings;
  settings.max_iterations = 60;  // let go all at once, it moves far in the first steps
  settings.restart_iteration = 60;
  RodSolver solver(mesh, settings, nullptr);
  solver.place(line_of_nodes(mesh), Vec3::UnitZ());
  const std::size_t base = mesh.node_count() - 1;
  solver.hold(base);
  solver.hold(base - 1);
  solver.hold_twist(base - 1);
  const double at_start = solver.elastic_energy();
  double before = at_start;
  for (int i = 0; i < 3000; ++i) {
    ASSERT_EQ(solver.step(), RodStatus::ok);
    double energy = solver.elastic_energy();
    for (std::size_t k = 0; k < mesh.node_count(); ++k) {
      energy += 0.5 * 5e-9 * mesh.cell_length[k] * solver.state().velocity[k].squaredNorm();
    }
    // an implicit step only loses energy; what the residual's tolerance leaves is far below 1e-5
    EXPECT_LE(energy, before + 1e-5 * at_start) << "step " << i;
    before = energy;
  }
  // it comes to rest in its own shape
  EXPECT_LT(before, 1e-6 * at_start);
}

// A rod pressed sideways into a wall and dragged along it, so that some nodes stick and some slip.
class TouchingRod : public ::testing::Test {
 protected:
  TouchingRod()
      : mesh_(uniform_mesh(20.0, 2.0, 40.0, 0.2)),
        wall_(Vec3::Zero(), Vec3::UnitZ()),
        solver_(mesh_, {}, &wall_) {
    std::vector<Vec3> nodes = line_of_nodes(mesh_);
    for (Vec3& node : nodes) {
      node.z() = 0.30 + 0.008 * node.x() + 0.01 * std::sin(node.x());
      node.y() = 0.1 * std::cos(0.3 * node.x());
      node.x() *= 1.01;  // under tension: the matrix leaves out what pressure would take away
    }
    solver_.place(nodes, Vec3::UnitY());
  }

  static double& unknown(RodState& state, std::size_t index) {
    std::vector<double>* coordinates[] = {&state.position.x, &state.position.y, &state.position.z,
                                          &state.twist};
    return (*coordinates[index % 4])[index / 4];
  }

  RodMesh mesh_;
  PlaneWall wall_;
  RodSolver solver_;
};

TEST_F(TouchingRod, MatrixIsTheDerivativeOfTheResidual) {
  RodState state = solver_.state();
  for (std::size_t i = 0; i < mesh_.node_count(); ++i) {
    const auto k = static_cast<double>(i);
    state.position.x[i] += 0.004 * std::sin(k);
    state.position.y[i] += 0.003 * std::cos(2.0 * k);
    if (i + 1 < mesh_.node_count()) state.twist[i] += 0.01 * std::sin(3.0 * k);
  }
  solver_.residual_at(state);
  state = solver_.state();  // frames carried over to the moved positions
  const RodBand band = solver_.matrix_at(state);
  ASSERT_GT(solver_.contact().contact_count(), 4);

  const std::size_t size = 4 * mesh_.node_count() - 1;
  const auto n = static_cast<Eigen::Index>(size);
  Eigen::MatrixXd exact = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixXd difference(n, n);
  constexpr double kStep = 1e-6;
  for (std::size_t j = 0; j < size; ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    for (std::size_t i = 0; i < size; ++i) {
      const bool inside = i <= j + RodBand::kReach && j <= i + RodBand::kReach;
      if (inside) exact(static_cast<Eigen::Index>(i), column) = band.at(i, j);
    }
    Eigen::VectorXd sides[2];
    for (int side = 0; side < 2; ++side) {
      RodState moved = state;
      unknown(moved, j) += side == 0 ? -kStep : kStep;
      const auto rows = solver_.residual_at(moved);
      sides[side] = Eigen::Map<const Eigen::VectorXd>(rows.data(), n);
    }
    difference.col(column) = (sides[1] - sides[0]) / (2.0 * kStep);
  }
  // Left out on purpose: how the friction's directions turn with the rod, and the skew part that
  // comes from transporting frames. Friction's own slopes are larger: 3.3 N/mm where it sticks,
  // mu kn = 1.3 N/mm by depth where it slips.
  const Eigen::MatrixXd error = difference - exact;
  double largest = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      if (i % 4 != 3 && j % 4 != 3) largest = std::max(largest, std::abs(error(i, j)));
    }
  }
  EXPECT_LT(largest, 0.5);
}

TEST(RodSolver, SameStepsGiveTheSameBytes) {
  std::vector<std::byte> states[2];
  for (auto& bytes : states) {
    const TubeWall tube = scenes::winding_tube(200.0, 36.0, 1.2);
    RodInstrument rod(scenes::stiff_wire(400.0, 0.15), Access{}, &tube, 60.0);
    double axial = 0.0;
    double rotation = 0.0;
    for (int i = 0; i < 400; ++i) {
      const scenes::Hand hand = scenes::random_hand(i * 1e-3);
      axial += hand.feed * 1e-3;
      rotation += hand.turn * 1e-3;
      ASSERT_EQ(rod.step(axial, rotation), RodStatus::ok);
    }
    rod.append_state(bytes);
  }
  ASSERT_EQ(states[0].size(), states[1].size());
  EXPECT_EQ(std::memcmp(states[0].data(), states[1].data(), states[0].size()), 0);
}

}  // namespace
}  // namespace sim
