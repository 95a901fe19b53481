// Whether what the database says of a trial (end, steps, events, metrics, verdict) is what the
// replay of its recorded inputs gives.
#pragma once

#include <string>

#include "app/session/trial_run.h"
#include "curricula/curriculum.h"
#include "database/store.h"
#include "database/trials.h"

namespace app {

// The first part that differs, in words ("the metric time_s"), or empty. Who made the trial, when
// and on what device cannot be replayed and is not covered.
base::Result<std::string> difference_from_record(database::Store& store,
                                                 const database::StoredTrial& stored,
                                                 const curricula::Exercise& exercise,
                                                 const TrialRun& replayed);

}  // namespace app
