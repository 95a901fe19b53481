// A guidewire or catheter as an elastic rod that is fed into a vessel through the introducer
// sheath. This is what the world steps; the mechanics underneath is RodSolver.
//
//        sheath (straight guide)      mouth = access
//   ==o====o====o====o====o====o====o====|--o---o---o--o--o-o-o  tip
//     ^ base: follows the handle         |     in the vessel: wall contact and friction
//
// The nodes are points of the material. Feeding moves them through the sheath and adds nodes at
// the base; withdrawing takes them away again. Inside the sheath nodes are guided sideways, slide
// freely along it and do not see the wall.
//
// Not here: who moves the handle, where the instrument's ends stop it (the world does that).
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "sim/anatomy/vessel.h"
#include "sim/contact/wall.h"
#include "sim/dynamics/rod_settings.h"
#include "sim/instrument/instrument.h"
#include "sim/math/vec3.h"

namespace sim {

class RodInstrument {
 public:
  // Starts at rest with `start_inserted` mm beyond the access. Without a path it is pushed there
  // from the mouth, so that it lies in the vessel as it would; with one (points along the lumen
  // from the access, mm, at least start_inserted long) it is laid along that and left to relax,
  // which is quicker. `wall` may be null (free space) and must outlive this. Throws
  // std::invalid_argument for an impossible instrument, frame or length, or when the start cannot
  // be reached.
  RodInstrument(const Instrument& instrument, const Access& access, const Wall* wall,
                double start_inserted, const RodSettings& settings = {},
                std::span<const Vec3> start_path = {});
  ~RodInstrument();
  RodInstrument(RodInstrument&&) noexcept;
  RodInstrument& operator=(RodInstrument&&) noexcept;

  // One step of settings.time_step towards the handle's new place, both counted from the start:
  // axial mm (positive pushes in), rotation rad (positive is clockwise seen by the operator, the
  // right hand's turn about access.direction). Allocates nothing. The caller keeps
  // 0 <= inserted_length() <= instrument.length. After `diverged` it must not be stepped.
  RodStatus step(double handle_axial, double handle_rotation);

  double inserted_length() const;     // mm of material beyond the access
  double handle_force() const;        // N, positive: it resists being pushed in
  double handle_torque() const;       // N mm, positive: it resists being turned clockwise
  double contact_force() const;       // N, largest |sum of wall reactions| over any 6 mm
  double contact_load() const;        // N, sum of the normal loads
  int contact_count() const;          // nodes touching the wall
  int iterations() const;             // of Newton's method in the last step
  double residual() const;            // N, largest unbalanced force left by the last step
  double find_contacts_time() const;  // s, spent asking the wall during the last step

  Vec3 tip() const;            // mm
  Vec3 tip_direction() const;  // unit, outward

  // Base to tip, all simulated nodes, and the wall's reaction (normal and friction) on each, N.
  std::span<const Vec3> nodes() const;
  std::span<const Vec3> node_forces() const;
  // Index of the last node at or behind the access: nodes().subspan(first_visible()) is the part
  // in the vessel.
  std::size_t first_visible() const;

  // Appends the whole state (positions, velocities, twists, frames, friction memory, handle) byte
  // by byte: what a hash of the state is taken over.
  void append_state(std::vector<std::byte>& bytes) const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace sim
