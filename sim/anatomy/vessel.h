// A vessel model ready for training: surface, wall, and where instruments enter. Built once,
// shared by all trials in it, never changed.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "sim/anatomy/triangle_mesh.h"
#include "sim/contact/wall.h"
#include "sim/math/vec3.h"

namespace sim {

// One point of a centreline.
struct CentrelinePoint {
  Vec3 position = Vec3::Zero();  // mm, patient frame LPS
  double radius = 0.0;           // mm, of the lumen
  double arc_length = 0.0;       // mm from the access
};

// Where instruments enter the vessel: the mouth of the introducer sheath.
struct Access {
  Vec3 position = Vec3::Zero();    // mm
  Vec3 direction = Vec3::UnitZ();  // unit, into the vessel
  Vec3 up = Vec3::UnitX();         // unit, normal to direction: the zero of the handle's rotation
};

// What a browser draws comfortably 60 times a second.
inline constexpr std::size_t kDisplayTriangles = 15000;

struct Vessel {
  std::string id;
  TriangleMesh surface;                     // closed, outward orientation: what the wall follows
  TriangleMesh display_surface;             // the same shape in at most kDisplayTriangles
  std::vector<CentrelinePoint> centreline;  // from the access to the far end
  Access access;
  std::unique_ptr<const Wall> wall;
};

}  // namespace sim
