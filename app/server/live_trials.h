// The trials that run right now, who sits at them, and what becomes of those nobody steers.
//
// Each trial has one seat that steers and any number that watch. Leaving the steering seat pauses
// the trial; whoever may steer and asks for it next takes it. Nobody steering for too long aborts
// the trial, which files it. Practice, of which nothing is kept, ends already when it has stood
// still for a while, somebody at it or not.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/session/live_trial.h"
#include "sim/base/result.h"

namespace app {

using Frame = std::shared_ptr<const std::vector<std::byte>>;  // shared: by all who are sent it

// Called from the trial's own threads; must return at once and not throw.
struct LiveListener {
  std::function<void(const Frame&)> frame;
  std::function<void(bool practice)> finished;     // filed, or not kept; nothing follows
  std::function<void(const std::string&)> failed;  // could not be filed, and why
};

// What POST /api/trials or /api/practice began, so that a lost tab can come back to it.
struct RunningTrial {
  std::string trial_id, person_id, exercise_id;
  int ordinal = 0;  // 0: practice
  bool practice = false;
  std::string device, started_utc;
};

// How long nobody may be at it.
struct LivePatience {
  double trial_s = 600.0;     // without anybody steering
  double practice_s = 300.0;  // standing still
};

class LiveTrials {
 public:
  struct Entry;

  // A place at a trial. Giving it up by destroying it.
  class Seat {
   public:
    Seat(std::shared_ptr<Entry> entry, std::size_t number, bool may_steer);
    ~Seat();
    Seat(const Seat&) = delete;
    Seat& operator=(const Seat&) = delete;

    // True when this seat steers now, taking the wheel if nobody holds it.
    bool take_wheel();
    // Each is ignored unless this seat steers.
    void command(const LiveCommand& command);
    void pause();
    void resume();
    void abort();

   private:
    bool steers() const;

    std::shared_ptr<Entry> entry_;  // shared: with the registry and the other seats
    std::size_t number_;
    bool may_steer_;
  };

  LiveTrials(int limit, LivePatience patience);
  ~LiveTrials();  // stops

  // One trial or practice per person: holds the person's place while it is being prepared. Fails
  // with conflict (has one running), or unavailable (as many run as the machine takes).
  base::Status reserve(const std::string& person_id);
  void release(const std::string& person_id);
  // Starts a reserved trial, paused. `on_finished`: called once from the trial's own thread when it
  // is judged, before anybody is told.
  base::Status start(const RunningTrial& trial, LiveTrialSetup setup,
                     std::function<void(const LiveResult&)> on_finished = {});

  std::optional<RunningTrial> of_person(const std::string& person_id);
  std::optional<RunningTrial> find(const std::string& trial_id);  // also one that just finished
  struct Running {
    RunningTrial about;
    bool paused = false;
  };
  std::vector<Running> running();          // in the order they were begun, practice left out
  bool runs(const std::string& trial_id);  // or has just finished
  // not_found when the trial does not run (any more).
  base::Result<std::unique_ptr<Seat>> sit(const std::string& trial_id, bool may_steer,
                                          LiveListener listener);
  // Aborts and files every trial.
  void stop();

 private:
  void forget_finished();  // under the lock

  const int limit_;
  const LivePatience patience_;
  std::mutex mutex_;
  std::set<std::string> reserved_;                         // people
  std::map<std::string, std::shared_ptr<Entry>> entries_;  // by trial; shared with its seats
  bool stopped_ = false;
};

}  // namespace app
