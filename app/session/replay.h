// Plays a stored trial again and says whether it is what it claims to be.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/session/scene.h"
#include "assessment/trial.h"
#include "database/store.h"

namespace app {

struct Verification {
  bool confirmed = false;
  bool same_build = false;            // only the same build promises equality
  std::string sentence;               // for the person who asked
  std::string chunk;                  // "inputs 3": the first stored chunk that was changed
  std::string differs;                // "the metric time_s": what else is not the replay's
  bool cut_off = false;               // ended by a crash, never judged: only its trace is compared
  std::optional<int> first_second;    // the first second that differs, counted from 0
  double largest_deviation_mm = 0.0;  // of the tip, between record and replay
  int seconds = 0;                    // simulated seconds compared
};

// `progress` gets 0..1; may be empty. Fails when the trial is unknown, has no trace, or its
// anatomy or instrument is not the one it was made with.
base::Result<Verification> verify_trial(database::Store& store, const std::string& trial_id,
                                        SceneStore& scenes,
                                        const std::function<void(double)>& progress);

// The trial as the replay of its recorded inputs gives it: metrics and traces can be taken from it.
base::Result<assessment::RecordedTrial> replay_trial(database::Store& store,
                                                     const std::string& trial_id,
                                                     SceneStore& scenes,
                                                     const std::function<void(double)>& progress);

}  // namespace app
