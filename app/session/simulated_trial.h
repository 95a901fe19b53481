// Runs one trial by a simulated operator, as fast as the machine allows, and files it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "app/session/scene.h"
#include "app/session/trial_file.h"
#include "curricula/curriculum.h"
#include "database/store.h"

namespace app {

struct SimulatedTrial {
  const curricula::Curriculum* curriculum = nullptr;
  const curricula::Exercise* exercise = nullptr;
  std::string skill;  // expert | intermediate | novice
  std::uint64_t seed = 0;
  int practice = 1;       // 1: the operator's first trial; later ones are better
  std::string person_id;  // under whom it is filed
};

struct SimulatedResult {
  BegunTrial begun;
  Judgement judgement;
  assessment::EndReason end_reason = assessment::EndReason::aborted;
  double simulated_s = 0.0;
  double wall_s = 0.0;
  std::string state_hash;
};

// `progress` gets the fraction of steps done; returning false stops the trial as aborted.
base::Result<SimulatedResult> run_simulated(database::Store& store, const SimulatedTrial& trial,
                                            std::shared_ptr<const Scene> scene,
                                            const std::function<bool(double)>& progress);

// The person simulated trials of a skill are filed under ("simulated:expert"), made when absent.
base::Result<std::string> simulated_person(database::Store& store, const std::string& name,
                                           const std::string& display_name,
                                           const std::string& skill);

}  // namespace app
