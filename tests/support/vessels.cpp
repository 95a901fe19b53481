#include "tests/support/vessels.h"

#include "sim/base/units.h"

namespace support {

using namespace base::units;

sim::TubeDescription s_bend_tube() {
  sim::TubeDescription tube;
  tube.id = "s-bend";
  tube.start_radius = 4.0;
  tube.legs = {{120.0, 0.0, 0.0, 4.0},
               {44.5, 85.0_deg, 0.0, 4.0},
               {65.5, 0.0, 0.0, 4.0},
               {44.5, -85.0_deg, 0.0, 4.0},
               {205.5, 0.0, 0.0, 4.0}};
  return tube;
}

const sim::Vessel& s_bend_vessel() {
  static const auto vessel = sim::build_tube_vessel(s_bend_tube(), 0.5);
  return *vessel;
}

sim::Instrument straight_guidewire() {
  sim::Instrument wire;
  wire.id = "straight-guidewire";
  wire.outer_diameter = 0.035_inch;
  wire.sections = {
      {30.0, 20.0, 15.4}, {40.0, 50.0, 38.5}, {50.0, 140.0, 107.7}, {1380.0, 291.0, 223.8}};
  for (const auto& section : wire.sections) wire.length += section.length;
  wire.friction = 0.08;
  return wire;
}

sim::Instrument angled_guidewire() {
  sim::Instrument wire = straight_guidewire();
  wire.id = "angled-guidewire";
  wire.tip_bends = {{3.0, 7.0, 45.0_deg / 7.0}};
  return wire;
}

}  // namespace support
