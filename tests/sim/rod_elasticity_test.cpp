// The rod's elastic forces and their derivatives against finite differences of the energy.
#include "sim/dynamics/rod_elasticity.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "sim/instrument/rod_mesh.h"

namespace sim {
namespace {

constexpr std::size_t kNodes = 7;
constexpr std::size_t kUnknowns = 4 * kNodes - 1;

// Two sections and a bent tip, so that straight and bent nodes and a change of stiffness are in it.
RodMesh small_mesh() {
  Instrument instrument;
  instrument.outer_diameter = 0.9;
  instrument.length = 12.0;
  instrument.sections = {{.length = 5.0, .bending_stiffness = 30.0, .twist_stiffness = 20.0},
                         {.length = 7.0, .bending_stiffness = 80.0, .twist_stiffness = 50.0}};
  instrument.tip_bends = {{.from_tip = 1.0, .length = 5.0, .curvature = 0.1}};
  return make_rod_mesh(instrument, {.element_length = 2.0, .tip_element_length = 2.0});
}

// Bent in space, stretched and twisted, by fixed irregular numbers.
RodState crooked_state() {
  RodState state(kNodes);
  state.node_count = kNodes;
  for (std::size_t i = 0; i < kNodes; ++i) {
    const auto k = static_cast<double>(i);
    state.position.set(i, {2.02 * k, 0.7 * std::sin(1.3 * k), 0.5 * std::cos(0.9 * k * k)});
    state.twist[i] = i + 1 < kNodes ? 0.3 * std::sin(2.0 * k) : 0.0;
    state.reference_cosine[i] = 1.0;
  }
  for (std::size_t i = 0; i + 1 < kNodes; ++i) {
    const Vec3 tangent = (state.position[i + 1] - state.position[i]).normalized();
    const Vec3 up(0.1, -0.3, 1.0);
    state.tangent.set(i, tangent);
    state.reference.set(i, (up - up.dot(tangent) * tangent).normalized());
  }
  return state;
}

double& unknown(RodState& state, std::size_t index) {
  std::vector<double>* coordinates[] = {&state.position.x, &state.position.y, &state.position.z,
                                        &state.twist};
  return (*coordinates[index % 4])[index / 4];
}

Eigen::VectorXd gradient(const RodElasticity& elasticity) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(kUnknowns);
  for (std::size_t edge = 0; edge + 1 < kNodes; ++edge) {
    const auto at = static_cast<Eigen::Index>(4 * edge);
    result.segment<3>(at) -= elasticity.edge_force(edge);
    result.segment<3>(at + 4) += elasticity.edge_force(edge);
    result[at + 3] = elasticity.twist_force(edge);
  }
  return result;
}

TEST(RodElasticity, ForcesAreTheGradientOfTheEnergy) {
  const RodMesh mesh = small_mesh();
  ASSERT_EQ(mesh.node_count(), kNodes);
  RodElasticity elasticity(mesh, 500.0);
  RodState state = crooked_state();
  elasticity.evaluate(state);
  const Eigen::VectorXd exact = gradient(elasticity);

  constexpr double kStep = 1e-5;
  for (std::size_t i = 0; i < kUnknowns; ++i) {
    double energies[2];
    for (int side = 0; side < 2; ++side) {
      RodState moved = state;
      unknown(moved, i) += side == 0 ? -kStep : kStep;
      elasticity.evaluate(moved);
      energies[side] = elasticity.energy(moved);
    }
    // the second-order difference of energies of order 100 N mm: 1e-10 truncation, 1e-9 rounding
    EXPECT_NEAR((energies[1] - energies[0]) / (2.0 * kStep), exact[static_cast<Eigen::Index>(i)],
                1e-6 * (1.0 + exact.norm()))
        << "unknown " << i;
  }
}

TEST(RodElasticity, MatrixIsTheDerivativeOfTheForces) {
  const RodMesh mesh = small_mesh();
  RodElasticity elasticity(mesh, 500.0);
  RodState state = crooked_state();
  elasticity.evaluate(state);
  RodBand band(kNodes);
  elasticity.assemble(state, band);
  Eigen::MatrixXd exact = Eigen::MatrixXd::Zero(kUnknowns, kUnknowns);
  for (std::size_t i = 0; i < kUnknowns; ++i) {
    for (std::size_t j = 0; j < kUnknowns; ++j) {
      if (i > j + RodBand::kReach || j > i + RodBand::kReach) continue;
      exact(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = band.at(i, j);
    }
  }
  EXPECT_LT((exact - exact.transpose()).norm(), 1e-12 * exact.norm());

  constexpr double kStep = 1e-5;
  Eigen::MatrixXd difference(kUnknowns, kUnknowns);
  for (std::size_t j = 0; j < kUnknowns; ++j) {
    Eigen::VectorXd gradients[2];
    for (int side = 0; side < 2; ++side) {
      RodState moved = state;
      unknown(moved, j) += side == 0 ? -kStep : kStep;
      elasticity.evaluate(moved);
      gradients[side] = gradient(elasticity);
    }
    difference.col(static_cast<Eigen::Index>(j)) = (gradients[1] - gradients[0]) / (2.0 * kStep);
  }
  // transport of the frames is path dependent, which leaves a skew part in the raw differences
  const Eigen::MatrixXd symmetric = 0.5 * (difference + difference.transpose());
  EXPECT_LT((symmetric - exact).cwiseAbs().maxCoeff(), 1e-6 * exact.cwiseAbs().maxCoeff());
}

TEST(RodElasticity, ReferenceTwistSurvivesSeveralTurns) {
  const RodMesh mesh = small_mesh();
  RodElasticity elasticity(mesh, 500.0);
  RodState state = crooked_state();
  elasticity.evaluate(state);
  const double before = elasticity.twist_moment(3);
  // turning all edges from node 3 on by three turns twists that node and nothing else
  for (int step = 0; step < 30; ++step) {
    for (std::size_t edge = 3; edge + 1 < kNodes; ++edge) {
      state.twist[edge] += 0.2 * std::acos(-1.0);
    }
    elasticity.evaluate(state);
  }
  EXPECT_NEAR(elasticity.twist_moment(3) - before, mesh.twisting[3] * 6.0 * std::acos(-1.0), 1e-9);
}

}  // namespace
}  // namespace sim
