// Stretch, bending and twist of a discrete elastic rod: forces and the exact second derivatives.
//
// At a node with edges e (towards the tip) and f (towards the base), lengths |e|, |f|, unit
// tangents t_e, t_f, c = t_e . t_f, kb = 2 t_e x t_f / (1 + c), cell length L:
//
//   stretch  EA (|e| - l)^2 / (2 l)
//   bending  (2 EI / L) (1 - c) / (1 + c)  -  (EI / L) kbar kappa,
//            kappa = (m2_e + m2_f) . kb / 2, kbar = the rest bend (absent on a straight shaft)
//   twist    GJ m^2 / (2 L),  m = twist_f - twist_e + reference twist
//
// (Bergou et al. 2008, 2010; Jawed, Novelia, O'Reilly: A Primer on the Kinematics of Discrete
// Elastic Rods, 2018.) Bending written in c instead of material-frame components makes Newton's
// method converge on an isotropic shaft.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/dynamics/rod_band.h"
#include "sim/dynamics/rod_state.h"
#include "sim/instrument/rod_mesh.h"

namespace sim {

class RodElasticity {
 public:
  RodElasticity(const RodMesh& mesh, double axial_stiffness);

  // Carries the frames in `state` over to its present positions and computes the forces there.
  void evaluate(RodState& state);

  // Derivative of the energy by edge vector `i` (pointing to the base), N.
  Vec3 edge_force(std::size_t i) const { return edge_force_[i]; }
  const Vec3Array& edge_forces() const { return edge_force_; }
  // Twisting moment at node `i`: derivative of the energy by its twist, N mm.
  double twist_moment(std::size_t i) const { return moment_[i]; }
  // Derivative of the energy by the twist angle of edge `i`, N mm.
  double twist_force(std::size_t i) const { return moment_[i] - moment_[i + 1] + extra_torque_[i]; }
  double stretch(std::size_t i) const { return length_[i] / rest_length_[i]; }
  double edge_length(std::size_t i) const { return length_[i]; }

  // Elastic energy of the last evaluated state, N mm.
  double energy(const RodState& state) const;

  // Overwrites rows 0 .. 4 node_count - 1 with the second derivatives at the last evaluated state.
  void assemble(const RodState& state, RodBand& band);

 private:
  void evaluate_edges(RodState& state);
  void evaluate_nodes(RodState& state);
  void add_rest_bends(const RodState& state);
  void evaluate_blocks(const RodState& state);
  void write_rows(const RodState& state, RodBand& band) const;
  void add_rest_bend_blocks(const RodState& state, RodBand& band) const;

  // the description
  std::vector<double> rest_length_, axial_, bending_, twisting_, rest_bend_;
  std::vector<std::size_t> bent_nodes_;  // those with a rest bend, from the tip

  // of the last evaluated state, per edge
  std::vector<double> length_, inverse_length_, tension_;
  Vec3Array edge_force_;
  std::vector<double> extra_torque_;
  // per node
  std::vector<double> cosine_, moment_, reference_step_sine_, reference_step_cosine_;
  Vec3Array binormal_, force_e_, force_f_;

  // Second derivatives by (e, f) of a node, and of its twisting moment by e and f. Symmetric
  // ones as xx xy xz yy yz zz, `ef` row by row.
  struct Blocks {
    double ee[6] = {}, ff[6] = {}, ef[9] = {};
    double twist_e[3] = {}, twist_f[3] = {};
    double twisting = 0.0;
  };
  static constexpr std::size_t kPad = 2;  // empty blocks at both ends, so that ends need no care
  std::vector<Blocks> blocks_;
};

}  // namespace sim
