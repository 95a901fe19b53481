// What a test asks of a surface, by counting, without the code that made it.
#pragma once

#include "sim/anatomy/triangle_mesh.h"
#include "sim/math/vec3.h"

namespace support {

// Each edge belongs to exactly two triangles that run it in opposite directions.
bool every_edge_is_shared_by_two(const sim::TriangleMesh& mesh);

// The triangles around each vertex form a single closed fan, and every vertex is used.
bool every_vertex_has_one_fan(const sim::TriangleMesh& mesh);

// Vertices - edges + triangles: 2 for a sphere, 0 for a torus, summed over the shells.
long euler_characteristic(const sim::TriangleMesh& mesh);

// Parts that hang together.
int shell_count(const sim::TriangleMesh& mesh);

double enclosed_volume(const sim::TriangleMesh& mesh);  // mm^3, negative when inside out

// How often the surface goes around the point, from the solid angles of all triangles (Van
// Oosterom and Strackee 1983): 1 inside, 0 outside.
double winding_number(const sim::TriangleMesh& mesh, const sim::Vec3& point);

}  // namespace support
