// The trials that run right now, who sits at them, and what becomes of those nobody steers.
//
// Each trial has one seat that steers and any number that watch. Leaving the steering seat pauses
// the trial; whoever may steer and asks for it next takes it. Nobody steering for too long aborts
// the trial, which files it.
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
  std::function<void()> filed;                     // in the database; nothing follows
  std::function<void(const std::string&)> failed;  // could not be filed, and why
};

// What POST /api/trials began, so that a lost tab can come back to it.
struct RunningTrial {
  std::string trial_id, person_id, exercise_id;
  int ordinal = 0;
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

  LiveTrials(int limit, double abandon_after_s);
  ~LiveTrials();  // stops

  // One trial per person: holds the person's place while the trial is being prepared. Fails with
  // conflict (has one running), or unavailable (as many run as the machine takes).
  base::Status reserve(const std::string& person_id);
  void release(const std::string& person_id);
  // Starts a reserved trial, paused.
  base::Status start(const RunningTrial& trial, LiveTrialSetup setup);

  std::optional<RunningTrial> of_person(const std::string& person_id);
  bool runs(const std::string& trial_id);  // or has just been filed
  // not_found when the trial does not run (any more).
  base::Result<std::unique_ptr<Seat>> sit(const std::string& trial_id, bool may_steer,
                                          LiveListener listener);
  // Aborts and files every trial.
  void stop();

 private:
  void forget_finished();  // under the lock

  const int limit_;
  const double abandon_after_s_;
  std::mutex mutex_;
  std::set<std::string> reserved_;                         // people
  std::map<std::string, std::shared_ptr<Entry>> entries_;  // by trial; shared with its seats
  bool stopped_ = false;
};

}  // namespace app
