// A guidewire or catheter as its maker describes it. A description: it never moves.
//
//   handle ======= back section =======|== front section ==|~ shaped tip ~>
//                                        arc length is counted from the tip backwards
//
// Units: mm, N, rad. Stiffness from a catalogue: EI = E pi d^4 / 64, GJ = G pi d^4 / 32.
#pragma once

#include <string>
#include <vector>

namespace sim {

// A stretch of constant stiffness. Sections are listed from the tip to the back.
struct InstrumentSection {
  double length = 0.0;             // mm
  double bending_stiffness = 0.0;  // EI, N mm^2
  double twist_stiffness = 0.0;    // GJ, N mm^2
};

// A stretch of constant rest curvature in the instrument's own plane; straight elsewhere.
struct TipBend {
  double from_tip = 0.0;   // mm of arc from the tip to the near end of the bend
  double length = 0.0;     // mm
  double curvature = 0.0;  // 1/mm, signed
};

struct Instrument {
  std::string id;
  double outer_diameter = 0.0;  // mm
  double inner_diameter = 0.0;  // mm, 0 for a wire
  double length = 0.0;          // mm, the sum of the sections
  std::vector<InstrumentSection> sections;
  std::vector<TipBend> tip_bends;
  double friction = 0.1;        // Coulomb coefficient against the wall
};

}  // namespace sim
