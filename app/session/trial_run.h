// One trial from the first step to the verdict: world and monitor together, and the recording where
// one is wanted. Knows no clock, no socket and no database; live trials, practice, simulated
// operators and replays all drive it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/session/exercise_monitor.h"
#include "app/session/scene.h"
#include "app/session/second_recorder.h"
#include "assessment/metrics.h"
#include "assessment/rule.h"
#include "assessment/trial.h"
#include "curricula/curriculum.h"
#include "sim/dynamics/world.h"

namespace app {

// Practice and rehearsals are judged like any trial and leave nothing behind.
enum class Recording { written, none };

class TrialRun {
 public:
  TrialRun(std::shared_ptr<const Scene> scene, const curricula::Exercise& exercise,
           Recording recording = Recording::written);
  ~TrialRun();

  // One step of the world, the monitor and the recording. No-op once ended.
  void step(const sim::HandleInput& input);
  bool ended() const;
  void abort();                       // the person gave up, or the connection was lost for good
  void note_event(const char* code);  // paused, resumed: stamped with the simulated time

  const sim::World& world() const;
  const ExerciseMonitor& monitor() const;

  // Seconds recorded since the last call; the unfinished one only once the trial has ended. None
  // without a recording.
  std::vector<RecordedSecond> take_recorded();

  // After the end.
  assessment::RecordedTrial recorded_trial() const;
  // Of a recorded run; empty without a recording.
  std::string state_hash() const;    // BLAKE2b-256 over the final state, hex
  std::string input_sha256() const;  // over all inputs, hex

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// What the verdict is made of.
struct Judgement {
  std::vector<assessment::MetricValue> metrics;
  std::vector<assessment::StepTime> step_times;
  assessment::Verdict verdict;
};
Judgement judge(const curricula::Exercise& exercise, const assessment::RecordedTrial& trial);

}  // namespace app
