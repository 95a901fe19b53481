// What came of practice, kept in memory for a few minutes so that the page can show it once. It is
// in no database and is gone with the server. May be used from several threads.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "app/session/live_trial.h"

namespace app {

struct PracticeResult {
  std::string person_id, exercise_id;
  LiveResult result;
};

class PracticeResults {
 public:
  static constexpr double kKept = 600.0;           // s
  static constexpr std::size_t kMostKept = 1'000;  // the oldest go first

  // `now`: steady_seconds().
  void keep(const std::string& practice_id, PracticeResult result, double now);
  std::optional<PracticeResult> find(const std::string& practice_id);
  std::optional<PracticeResult> find(const std::string& practice_id, double now);

 private:
  struct Kept {
    PracticeResult result;
    double since = 0.0;
  };
  std::mutex mutex_;
  std::map<std::string, Kept> kept_;  // by id, which is by time
};

}  // namespace app
