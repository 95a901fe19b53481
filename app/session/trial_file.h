// A trial's way into the database and out again: begun, written second by second, closed with its
// judgement; and rebuilt from what is stored.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "app/session/scene.h"
#include "app/session/trial_run.h"
#include "assessment/trial.h"
#include "curricula/curriculum.h"
#include "database/store.h"
#include "database/trials.h"

namespace app {

// How wall time and simulated time went apart while the trial ran.
struct WallTime {
  double paused = 0.0;         // s
  double slowed = 0.0;         // s
  double longest_pause = 0.0;  // s
};

// A pause over 5 s, or simulated time slowed by over 2 %: shown, not counted for proficiency.
bool is_interrupted(const WallTime& wall, double simulated);

// Who does which exercise with what.
struct TrialHead {
  std::string person_id;
  std::string curriculum_id;
  std::string exercise_id;
  assessment::Source source = assessment::Source::live;
  std::string device;  // keyboard, simulated:expert, ...
  std::uint64_t seed = 0;
};

struct BegunTrial {
  std::string trial_id;
  int ordinal = 0;
};

// Enrols the person where needed and opens the trial.
base::Result<BegunTrial> begin(database::Store& store, const TrialHead& head, const Scene& scene);

// Appends what one or more seconds left. Call it about once a second.
base::Status append(database::Store& store, const std::string& trial_id,
                    std::span<const RecordedSecond> seconds);

// Judges the ended run, with what the wall clock knows of it. Stores nothing.
Judgement judge(const curricula::Exercise& exercise, const TrialRun& run, const WallTime& wall);

// Judges the ended run and closes the trial, its last seconds with it.
base::Result<Judgement> finish(database::Store& store, const std::string& trial_id, TrialRun& run,
                               const curricula::Exercise& exercise, const WallTime& wall);

// The trial as metrics see it, rebuilt from the stored trace.
base::Result<assessment::RecordedTrial> load_recorded(database::Store& store,
                                                      const std::string& trial_id);

// The exercise exactly as it was when the trial was made.
base::Result<curricula::Exercise> exercise_of(database::Store& store,
                                              const database::StoredTrial& trial,
                                              const curricula::Catalogue& catalogue);

}  // namespace app
