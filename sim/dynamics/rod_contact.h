// Contact and Coulomb friction of a rod's nodes with the wall, as forces and as the derivatives
// Newton's method needs.
//
// Normal force f(d) for a node d deep in the wall: kn d^2 / (2 w) up to the onset w, then
// kn (d - w/2), and beyond the soft depth s another kn a (d - s)^2 / 2. Friction is one 2-vector
// per node, along the rod and around it:
//
//   slip in the step    s = (tau . dx, b . dx + r dpsi)     tau: along, b: around the rod
//   bristle force       f* = kt (z + s), cut back to mu f   z: elastic slip kept from before
//
// with psi the mean turn of the two edges at the node. So the rod sticks without creeping, and
// turning it relieves friction along it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/contact/wall.h"
#include "sim/dynamics/rod_band.h"
#include "sim/dynamics/rod_settings.h"
#include "sim/dynamics/rod_state.h"
#include "sim/instrument/rod_mesh.h"

namespace sim {

class RodContact {
 public:
  // `wall` may be null: nothing to touch.
  RodContact(const RodMesh& mesh, const RodSettings& settings, const Wall* wall);

  // Share of the contact stiffness that node `i` has, 0 to 1; starts at 1 for all nodes. Nodes
  // from `end` on are not asked about at all.
  void set_share(std::size_t i, double share) { share_[i] = share; }
  void set_end(std::size_t end) { end_ = end; }

  // Finds the contacts at the present positions. `start`, `start_twist`: where the step began.
  void evaluate(const RodState& state, const Vec3Array& start,
                const std::vector<double>& start_twist);
  // Adds minus the forces to the residual, four rows per node.
  void add_to_residual(double* residual) const;
  void add_to_band(RodBand& band) const;
  // Keeps the bristles' new elastic slip; those out of contact forget.
  void store_bristles(RodState& state) const;

  int contact_count() const { return static_cast<int>(contacts_.size()); }
  double normal_load() const;                      // N, sum of the normal forces
  void node_forces(std::span<Vec3> forces) const;  // N, wall on node, numbered from the tip
  double wall_time() const { return wall_time_; }  // s since reset_wall_time
  void reset_wall_time() { wall_time_ = 0.0; }

 private:
  struct Contact {
    std::size_t node = 0;
    Vec3 normal, along, around;
    double force = 0.0;         // N, normal
    double stiffness = 0.0;     // N/mm, its slope
    double friction[2] = {};    // N, along and around, as it resists
    double tangent[3] = {};     // N/mm, its slope by slip: aa ab bb
    double push[2] = {};        // its slope by depth: N/mm, zero while it sticks
    double lever_before = 0.0;  // mm, of the edge towards the tip
    double lever_behind = 0.0;
  };
  void evaluate_friction(const RodState& state, const Vec3Array& start,
                         const std::vector<double>& start_twist, Contact& contact) const;

  const Wall* wall_;
  double radius_, friction_, onset_, soft_depth_, hardening_, wall_curvature_;
  std::vector<double> normal_stiffness_, friction_stiffness_;  // N/mm per node
  std::vector<double> share_;
  std::size_t end_;
  std::vector<Vec3> points_;
  std::vector<WallSample> samples_;
  std::vector<Contact> contacts_;
  double wall_time_ = 0.0;
};

}  // namespace sim
