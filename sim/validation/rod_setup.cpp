#include "sim/validation/rod_setup.h"

#include <algorithm>

namespace sim::validation {

Instrument uniform_instrument(double length, double bending_stiffness, double twist_stiffness,
                              double outer_diameter, double friction) {
  Instrument instrument;
  instrument.id = "uniform";
  instrument.outer_diameter = outer_diameter;
  instrument.length = length;
  instrument.sections = {{.length = length,
                          .bending_stiffness = bending_stiffness,
                          .twist_stiffness = twist_stiffness}};
  instrument.friction = friction;
  return instrument;
}

RodMesh clamped_mesh(const Instrument& instrument, int elements) {
  const double element = instrument.length / elements;
  RodMesh mesh = make_rod_mesh(instrument, {.element_length = element,
                                            .tip_element_length = element,
                                            .tip_mesh_length = instrument.length + element,
                                            .extension = element});
  const auto clamp = static_cast<std::size_t>(elements);
  mesh.bending[clamp] *= 2.0;
  mesh.twisting[clamp] *= 2.0;
  return mesh;
}

RodSettings static_settings(double length, double bending_stiffness, double force) {
  RodSettings settings;
  settings.time_step = 1e3;
  settings.drag = 0.0;
  settings.tolerance = 1e-6 * force;
  settings.axial_stiffness = std::max(1e6 * force, 1e4 * bending_stiffness / (length * length));
  settings.max_iterations = 100;
  settings.restart_iteration = 50;
  settings.max_move = 0.05 * length;
  settings.impossible_move = 2.0 * length;
  return settings;
}

std::vector<Vec3> straight_nodes(const RodMesh& mesh, double length) {
  std::vector<Vec3> nodes;
  for (double arc : mesh.arc) nodes.emplace_back(length - arc, 0.0, 0.0);
  return nodes;
}

base::Error simulation_failed() {
  return {base::ErrorCode::unavailable,
          "The simulation did not converge with these parameters; try milder ones."};
}

}  // namespace sim::validation
