// The catalogue on disk: instruments, anatomies and built-in curricula under one library folder.
//
//   DIR/instruments/*.yaml   DIR/anatomies/*.yaml   DIR/library/*.yaml
//
// These are descriptions of the file; app turns them into what sim computes with.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "curricula/check.h"
#include "sim/base/result.h"

namespace curricula {

struct InstrumentSectionSpec {
  double length = 0.0, bending_stiffness = 0.0, twist_stiffness = 0.0;
};
struct TipBendSpec {
  double from_tip = 0.0, length = 0.0, angle = 0.0;
};  // rad over the length

struct InstrumentSpec {
  std::string id;
  std::string title;
  std::string kind;                                   // guidewire | catheter
  double outer_diameter = 0.0, inner_diameter = 0.0;  // mm
  std::vector<InstrumentSectionSpec> sections;        // mm, N mm^2; from the tip to the back
  std::string tip_shape;                              // straight | angled
  std::vector<TipBendSpec> tip_bends;
  double friction = 0.0;
  std::string source;     // citation of the stiffness
  std::string sha256;     // of the file
  double length() const;  // mm
};

// A single tube made of straight legs and arcs in order, each bent in a plane turned by `plane`
// about the current direction.
struct TubeLegSpec {
  double length = 0.0;
  double bend = 0.0;
  double plane = 0.0;
  double radius = 0.0;
};
// length mm of arc; bend rad over the length; plane rad; lumen radius mm at the leg's end

struct AnatomySpec {
  std::string id;
  std::string title;
  double voxel = 0.5;                 // mm
  double start_radius = 0.0;          // mm
  std::array<double, 3> access{};     // mm, LPS
  std::array<double, 3> direction{};  // unit, into the vessel
  std::vector<TubeLegSpec> legs;
  std::string source;
  std::string sha256;
  double length() const;  // mm of centreline
};

struct Library {
  std::vector<InstrumentSpec> instruments;
  std::vector<AnatomySpec> anatomies;
  std::vector<Curriculum> curricula;
  Catalogue catalogue() const;
  const InstrumentSpec* instrument(const std::string& id) const;
  const AnatomySpec* anatomy(const std::string& id) const;
};

// Loads and checks everything under `folder`. The first broken file fails the whole with its
// name and line.
base::Result<Library> load_library(const std::string& folder);

}  // namespace curricula
