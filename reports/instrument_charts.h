// An instrument drawn: how stiff it is along its length, and its tip at rest, to scale.
#pragma once

#include <string>
#include <vector>

#include "reports/chart.h"
#include "reports/svg.h"

namespace reports {

struct StiffnessSection {
  double length = 0.0;             // mm, from the tip to the back
  double bending_stiffness = 0.0;  // N mm^2
  double twist_stiffness = 0.0;    // N mm^2
};
struct TipBend {
  double from_tip = 0.0, length = 0.0;  // mm
  double angle = 0.0;                   // rad over the length
};

// EI and GJ over the distance from the tip, on a logarithmic axis.
Chart stiffness_chart(const std::string& id, const std::string& instrument,
                      const std::vector<StiffnessSection>& sections);

// The centreline at rest in its plane, mm: from (0, 0), where it runs along x, `shown` mm from the
// tip, to the tip. One point each half millimetre; exact for constant curvature.
std::vector<Point> tip_line(const std::vector<TipBend>& bends, double shown);

// The same as a drawing with a scale bar.
Chart tip_chart(const std::string& id, const std::string& instrument,
                const std::vector<TipBend>& bends, double outer_diameter);

}  // namespace reports
