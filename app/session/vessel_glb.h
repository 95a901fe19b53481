// A surface as a glTF 2.0 binary file (.glb), for the browser to draw.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/anatomy/triangle_mesh.h"

namespace app {

// One mesh with POSITION and NORMAL (float32) and indices (uint32), little endian, in mm and the
// patient frame of the mesh. Throws std::invalid_argument when the mesh is empty or has not one
// normal per vertex.
std::vector<std::byte> encode_glb(const sim::TriangleMesh& mesh);

}  // namespace app
