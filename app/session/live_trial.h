// A trial steered by a person right now: its own thread steps the world at 1 kHz of wall time,
// takes commands, and leaves a picture of the state 60 times a second.
//
//   socket thread --command()--> [mailbox] --> simulation thread --> frame() --> socket threads
//                                                     |
//                                                     +--> writer thread --> TrialKeeper
//
// Losing the connection pauses: nothing moves and the clock notes it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/session/scene.h"
#include "app/session/trial_keeper.h"
#include "app/session/trial_run.h"
#include "curricula/curriculum.h"

namespace app {

// What the hand does now, until the next command.
struct LiveCommand {
  double feed = 0.0;    // mm/s held
  double turn = 0.0;    // rad/s held
  double move = 0.0;    // mm to add once (mouse drag), done as fast as the handle allows
  double rotate = 0.0;  // rad to add once
};

struct LiveTrialSetup {
  std::string trial_id;
  std::string person_id;
  std::shared_ptr<const Scene> scene;
  curricula::Exercise exercise;
  std::unique_ptr<TrialKeeper> keeper;
};

// What came of it.
struct LiveResult {
  assessment::EndReason end_reason = assessment::EndReason::aborted;
  Judgement judgement;
  bool interrupted = false;  // too long a pause, or slowed down: shown, not counted
};

class LiveTrial {
 public:
  // A trial that is to be filed must be begun in the database. Starts paused.
  explicit LiveTrial(LiveTrialSetup setup);
  ~LiveTrial();  // a trial not ended is aborted and given to its keeper

  void command(const LiveCommand& command);
  void pause();
  void resume();
  void abort();

  // A frame in the wire format (app/wire/frame.h), complete and never half-written. Empty before
  // the first. `last` is the number of the frame one has already; null when there is no newer.
  std::shared_ptr<const std::vector<std::byte>> frame(std::uint64_t& last) const;
  // Waits up to `timeout_ms` for a newer frame.
  bool wait_frame(std::uint64_t last, int timeout_ms) const;

  bool paused() const;
  bool ended() const;                // the simulation is over
  bool finished() const;             // and judged; unless it is practice, it is in the database
  std::string failure() const;       // why it could not be filed, or empty
  const LiveResult& result() const;  // once finished
  const std::string& trial_id() const;
  const std::string& person_id() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace app
