// Writes a run down as it goes, one simulated second at a time, in the bytes of recording.h. A part
// of TrialRun that practice does without.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/session/recording.h"
#include "assessment/trial.h"
#include "sim/dynamics/world.h"

namespace app {

// The recording of one simulated second (the last one may be shorter).
struct RecordedSecond {
  int seq = 0;
  std::vector<std::byte> inputs;    // codec "inputs/1"
  std::vector<std::byte> observed;  // codec "observed/1"
  std::vector<std::byte> hashes;    // codec "hashes/1"
  std::vector<assessment::Event> events;
};

class SecondRecorder {
 public:
  SecondRecorder();

  // The hand starts at rest, so that only a change has to be noted.
  void note_input(std::uint32_t step, const sim::HandleInput& input);
  void note_sample(std::uint32_t step, const assessment::Sample& sample);
  // Completes the second that ends here. `events`: all of the run so far.
  void close_second(std::uint32_t step, const sim::World& world,
                    const std::vector<assessment::Event>& events);

  std::vector<RecordedSecond> take();  // completed since the last call
  std::string state_hash() const;      // BLAKE2b-256 of the last state hashed, hex
  std::string input_sha256() const;    // over all inputs, hex

 private:
  void reserve();

  RecordedSecond current_;
  std::vector<RecordedSecond> complete_;
  std::size_t events_taken_ = 0;
  std::vector<std::byte> all_inputs_;
  std::vector<std::byte> state_;
  Hash last_state_{};
};

}  // namespace app
