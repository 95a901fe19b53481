// Vessels and instruments that several tests and benchmarks share.
#pragma once

#include <memory>

#include "sim/anatomy/tube.h"
#include "sim/anatomy/vessel.h"
#include "sim/instrument/instrument.h"

namespace support {

// Radius 4 mm, 480 mm long: straight to 120, two opposite bends of 85 degrees and 30 mm radius with
// 65.5 mm between them, straight from 274.5.
sim::TubeDescription s_bend_tube();
// Built once per process.
const sim::Vessel& s_bend_vessel();

// 0.035": a shaft of EI 291 N mm^2 that softens over 120 mm to a tip of 20.
sim::Instrument straight_guidewire();
// The same, bent by 45 degrees over the last centimetre.
sim::Instrument angled_guidewire();

}  // namespace support
