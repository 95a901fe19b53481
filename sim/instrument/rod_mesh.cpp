#include "sim/instrument/rod_mesh.h"

#include <algorithm>
#include <cmath>

#include "sim/base/require.h"

namespace sim {
namespace {

// The length that [from, to] and [start, start + length] have in common.
double overlap(double from, double to, double start, double length) {
  return std::max(0.0, std::min(to, start + length) - std::max(from, start));
}

// Integral of 1/stiffness over [from, to]; the last section continues beyond its end.
double compliance(const Instrument& instrument, double InstrumentSection::*stiffness, double from,
                  double to) {
  double sum = 0.0;
  double start = 0.0;
  for (const InstrumentSection& section : instrument.sections) {
    const bool last = &section == &instrument.sections.back();
    const double length = last ? std::max(section.length, to - start) : section.length;
    sum += overlap(from, to, start, length) / section.*stiffness;
    start += section.length;
  }
  return sum;
}

double rest_angle(const Instrument& instrument, double from, double to) {
  double sum = 0.0;
  for (const TipBend& bend : instrument.tip_bends) {
    sum += bend.curvature * overlap(from, to, bend.from_tip, bend.length);
  }
  return sum;
}

void check(const Instrument& instrument, const RodMeshSizes& sizes) {
  base::require(!instrument.sections.empty(), "an instrument needs at least one section");
  for (const InstrumentSection& section : instrument.sections) {
    base::require(section.length > 0.0, "a section's length must be positive");
    base::require(section.bending_stiffness > 0.0, "bending stiffness must be positive");
    base::require(section.twist_stiffness > 0.0, "twist stiffness must be positive");
  }
  base::require(instrument.length > 0.0, "an instrument's length must be positive");
  base::require(instrument.outer_diameter > 0.0, "an outer diameter must be positive");
  base::require(instrument.friction >= 0.0, "a friction coefficient cannot be negative");
  base::require(sizes.element_length > 0.0 && sizes.tip_element_length > 0.0,
                "element lengths must be positive");
}

// Appends nodes up to `end`, equally spaced by at most `spacing`.
void fill(std::vector<double>& arc, double end, double spacing) {
  const double start = arc.back();
  if (end - start < 1e-9) return;
  const auto count = static_cast<int>(std::max(1.0, std::ceil((end - start) / spacing - 1e-9)));
  for (int i = 1; i <= count; ++i) arc.push_back(start + (end - start) * i / count);
}

}  // namespace

RodMesh make_rod_mesh(const Instrument& instrument, const RodMeshSizes& sizes) {
  check(instrument, sizes);
  const double end = instrument.length + sizes.extension;
  double fine_end = sizes.tip_mesh_length;
  for (const TipBend& bend : instrument.tip_bends) {
    fine_end = std::max(fine_end, bend.from_tip + bend.length + sizes.tip_element_length);
  }

  RodMesh mesh;
  mesh.radius = 0.5 * instrument.outer_diameter;
  mesh.friction = instrument.friction;
  mesh.arc.push_back(0.0);
  fill(mesh.arc, std::min(fine_end, end), sizes.tip_element_length);
  fill(mesh.arc, end, sizes.element_length);

  const std::size_t count = mesh.arc.size();
  for (std::size_t i = 0; i + 1 < count; ++i) {
    mesh.edge_length.push_back(mesh.arc[i + 1] - mesh.arc[i]);
  }
  mesh.bending.assign(count, 0.0);
  mesh.twisting.assign(count, 0.0);
  mesh.rest_bend.assign(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const bool inner = i > 0 && i + 1 < count;
    const double from = i > 0 ? 0.5 * (mesh.arc[i - 1] + mesh.arc[i]) : 0.0;
    const double to = i + 1 < count ? 0.5 * (mesh.arc[i] + mesh.arc[i + 1]) : end;
    mesh.cell_length.push_back(to - from);
    if (!inner) continue;
    mesh.bending[i] = 1.0 / compliance(instrument, &InstrumentSection::bending_stiffness, from, to);
    mesh.twisting[i] = 1.0 / compliance(instrument, &InstrumentSection::twist_stiffness, from, to);
    mesh.rest_bend[i] = 2.0 * std::tan(0.5 * rest_angle(instrument, from, to));
  }
  return mesh;
}

}  // namespace sim
