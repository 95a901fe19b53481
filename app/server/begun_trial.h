// What beginning a trial and beginning practice share.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "app/server/live_trials.h"
#include "app/server/site.h"
#include "app/server/training_record.h"
#include "database/store.h"

namespace app {

// Holds the person's place among the live trials while one is being prepared.
class Reservation {
 public:
  Reservation(LiveTrials& live, std::string person_id)
      : live_(live), person_id_(std::move(person_id)) {}
  ~Reservation() { live_.release(person_id_); }
  Reservation(const Reservation&) = delete;
  Reservation& operator=(const Reservation&) = delete;

 private:
  LiveTrials& live_;
  std::string person_id_;
};

// Plain words only: the device is stored, and read in lists.
base::Status check_device(const std::string& device);

// The exercise of a running trial as its person sees it.
base::Result<nlohmann::json> running_briefing_json(const TrainingRecord& record, Site& site,
                                                   const RunningTrial& trial);

// The answer to beginning one, and to asking for it again.
base::Result<nlohmann::json> begun_json(const TrainingRecord& record, Site& site,
                                        const RunningTrial& trial);

}  // namespace app
