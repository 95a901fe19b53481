// One picture of a live trial in the wire format of app/wire/wire.schema.yaml.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "app/session/trial_run.h"

namespace app {

// What the run itself does not know.
struct FrameContext {
  std::uint32_t frame = 0;
  bool paused = false;
  bool filed = false;
  double paused_for = 0.0;  // s of wall time so far
  double slowed_for = 0.0;  // s
};

// The largest values so far, as the gauges show them.
struct GaugePeaks {
  double handle_force = 0.0, handle_torque = 0.0, contact_force = 0.0;
  void take(const sim::Observation& seen);
};

std::vector<std::byte> encode_frame(const TrialRun& run, const GaugePeaks& peaks,
                                    const FrameContext& context);

}  // namespace app
