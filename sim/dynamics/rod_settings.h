// Numbers that choose how the rod is computed, as opposed to what the instrument is.
#pragma once

namespace sim {

enum class RodStatus { ok, diverged };

struct RodSettings {
  // mesh
  double element_length = 3.0;      // mm
  double tip_element_length = 2.0;  // mm, over the first tip_mesh_length and over tip bends
  double tip_mesh_length = 40.0;    // mm
  double sheath_length = 24.0;      // mm of straight guide before the access

  // material beyond what the instrument's description holds
  double axial_stiffness = 1e4;  // EA, N
  double line_density = 5e-9;    // t/mm
  double drag = 1e-6;            // N s/mm per mm of length
  double twist_drag = 1e-7;      // N mm s per mm of length

  // contact, for a node that stands for 3 mm of length, and for the tip; scaled with the length
  // that a node stands for
  double contact_stiffness = 10.0;    // N/mm
  double contact_onset = 0.1;         // mm, over which the stiffness builds up
  double contact_soft_depth = 0.4;    // mm, beyond which the wall stiffens, so as to hold anything
  double contact_hardening = 25.0;    // 1/mm, growth of the stiffness from there, as a multiple
  double friction_stiffness = 5.0;    // N/mm, of the bristles
  double wall_curvature = 1.0 / 3.0;  // 1/mm, of the lumen across its axis; only for the tangent

  // solver
  double time_step = 1e-3;        // s
  double tolerance = 5e-4;        // N, largest unbalanced force (torques count 0.45 per mm)
  int max_iterations = 16;        // one does for nearly every step; the rare hard one is finished
  int restart_iteration = 3;      // here the prediction is dropped, once
  double max_move = 2.0;          // mm, of any node in one iteration
  double impossible_move = 50.0;  // mm, of any node in one step: something has broken
};

}  // namespace sim
