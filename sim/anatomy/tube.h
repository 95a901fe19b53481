// A vessel without branches, described as one would bend a wire: straight legs and arcs in order.
// From this description comes a volume, and from the volume the surface, by the same marching
// cubes that a patient's scan goes through.
//
//   access                      bend > 0
//     |==== leg 0 (bend 0) ====.                 plane turns the bend about the
//    sheath                     `. leg 1         current direction; the frame is
//    mouth                        |              carried along without twisting
//                                 | leg 2
//
// The lumen goes on behind the access by kSheathOverhang, so that the sheath's mouth lies inside;
// both ends are closed by domes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/anatomy/triangle_mesh.h"
#include "sim/anatomy/vessel.h"
#include "sim/math/vec3.h"

namespace sim {

inline constexpr double kSheathOverhang = 10.0;  // mm of lumen behind the access

struct TubeLeg {
  double length = 0.0;      // mm of arc
  double bend = 0.0;        // rad over the length; 0 is straight; negative bends the other way
  double plane = 0.0;       // rad, turns the bend about the direction the leg starts in
  double end_radius = 0.0;  // mm of the lumen; between legs the radius goes over smoothly
};

struct TubeDescription {
  std::string id;
  double start_radius = 0.0;       // mm, at the access
  Vec3 access = Vec3::Zero();      // mm, LPS
  Vec3 direction = Vec3::UnitZ();  // into the vessel, any length
  std::vector<TubeLeg> legs;
};

// From the access to the far end, a point about every `step` mm and at each end of a leg. Throws
// std::invalid_argument when the description is impossible: no legs, a length or radius that is
// not positive, a bend of less radius than the lumen.
std::vector<CentrelinePoint> tube_centreline(const TubeDescription& tube, double step);

// The closed surface, from voxels of the given edge length in mm. Throws as above, and when the
// voxel is larger than half of the smallest radius.
TriangleMesh tube_surface(const TubeDescription& tube, double voxel);

// Everything a trial needs: surface, centreline, access and the wall surveyed from the surface.
std::unique_ptr<Vessel> build_tube_vessel(const TubeDescription& tube, double voxel);

}  // namespace sim
