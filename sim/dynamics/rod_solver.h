// One discrete elastic rod, stepped implicitly in time (backward Euler) with contact and friction
// inside the solve. Knows nothing of sheaths, handles or instruments: whoever uses it says which
// degrees of freedom are held and how they move, what pulls, and where the wall counts.
//
// Nodes are numbered from the tip, so that a rod that is fed in grows at the end of the arrays.
//
// Newton's method on all positions and twist angles at once, from a prediction at constant
// velocity; when that does not converge, once more from where the step began.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/contact/wall.h"
#include "sim/dynamics/rod_band.h"
#include "sim/dynamics/rod_contact.h"
#include "sim/dynamics/rod_elasticity.h"
#include "sim/dynamics/rod_settings.h"
#include "sim/dynamics/rod_state.h"
#include "sim/instrument/rod_mesh.h"
#include "sim/math/vec3.h"

namespace sim {

class RodSolver {
 public:
  // The mesh says how long the rod can become. `wall` may be null and must outlive the solver.
  RodSolver(const RodMesh& mesh, const RodSettings& settings, const Wall* wall);

  // Puts the first nodes.size() nodes there, at rest and untwisted: material directions are
  // carried along the rod from the base, where the first one is `up`. At least 3 nodes.
  void place(std::span<const Vec3> nodes, const Vec3& up);

  // --- what acts on the rod; stays until changed
  void hold(std::size_t node, bool held = true);                  // its position
  void hold_along(std::size_t node, int axis, bool held = true);  // one coordinate of it
  void hold_twist(std::size_t edge, bool held = true);
  void set_load(std::size_t node, const Vec3& force) { load_.set(node, force); }  // N
  // A straight guide: pulls node i back to the line through `point` along `axis` with stiffness
  // guide_stiffness(i), N/mm, and lets it slide.
  void set_guide(const Vec3& point, const Vec3& axis);
  void set_guide_stiffness(std::size_t node, double stiffness) { guide_[node] = stiffness; }
  RodContact& contact() { return contact_; }
  const RodContact& contact() const { return contact_; }

  // --- how held degrees of freedom move during the next step; forgotten after it
  void move(std::size_t node, const Vec3& displacement);  // mm
  void turn(std::size_t edge, double angle);              // rad, about the tangent

  RodStatus step();

  // --- growth at the base, without disturbing the balance: the new edge is stretched and twisted
  // like its neighbour. Returns the new node's place along `axis` behind the old base.
  void append_node(const Vec3& axis);
  void remove_node();

  // --- what came out of the last step
  std::size_t node_count() const { return state_.node_count; }
  std::size_t capacity() const { return mesh_.node_count(); }
  const RodMesh& mesh() const { return mesh_; }
  const RodState& state() const { return state_; }
  Vec3 position(std::size_t node) const { return state_.position[node]; }
  int iterations() const { return iterations_; }
  double residual() const { return residual_norm_; }  // N
  // What the holders must apply: force on a held node (N, without its inertia) and moment about
  // the tangent of a held edge (N mm).
  Vec3 holding_force(std::size_t node) const;
  double holding_moment(std::size_t edge) const;
  double twist_moment(std::size_t node) const { return elasticity_.twist_moment(node); }
  double elastic_energy() const { return elasticity_.energy(state_); }  // N mm

  // For tests of the derivatives: the residual of one step (four rows per node) at the given
  // state, and the matrix Newton's method would use there.
  std::span<const double> residual_at(const RodState& state);
  const RodBand& matrix_at(const RodState& state);

 private:
  void begin_step();
  void predict();
  void restart();
  void evaluate();
  void add_rows();
  double measure() const;
  void assemble();
  double apply(double damping);
  void finish_step();

  RodMesh mesh_;
  RodSettings settings_;
  RodElasticity elasticity_;
  RodContact contact_;
  RodBand band_;
  RodState state_;
  RodState start_;                                // at the beginning of the step
  std::vector<double> mass_, drag_, twist_drag_;  // already divided by dt^2 and dt
  Vec3Array load_;
  std::vector<double> guide_;
  Vec3 guide_point_ = Vec3::Zero();
  Vec3 guide_axis_ = Vec3::UnitZ();
  std::vector<std::uint8_t> held_;  // per degree of freedom
  std::vector<double> motion_;      // of the held ones in the next step
  std::vector<double> residual_, change_;
  int iterations_ = 0;
  double residual_norm_ = 0.0;
};

}  // namespace sim
