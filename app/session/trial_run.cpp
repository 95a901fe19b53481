#include "app/session/trial_run.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "app/session/recording.h"

namespace app {
namespace {

std::array<double, 3> array_of(const sim::Vec3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

struct TrialRun::Parts {
  Parts(std::shared_ptr<const Scene> its_scene, const curricula::Exercise& exercise,
        Recording recording)
      : scene(std::move(its_scene)),
        exercise_id(exercise.id),
        world(scene->scenario()),
        monitor(exercise) {
    if (recording == Recording::written) recorder.emplace();
    trial.samples.reserve(120 * 100);
    take_sample();
  }

  std::uint32_t step_number() const { return static_cast<std::uint32_t>(world.observation().step); }
  double time() const { return step_number() * sim::kStepLength; }

  void take_sample() {
    const sim::Observation& seen = world.observation();
    assessment::Sample sample;
    sample.time = time();
    sample.tip = array_of(seen.tip);
    sample.tip_direction = array_of(seen.tip_direction);
    sample.handle_axial = seen.handle_axial;
    sample.handle_rotation = seen.handle_rotation;
    sample.inserted_length = seen.inserted_length;
    sample.handle_force = seen.handle_force;
    sample.handle_torque = seen.handle_torque;
    sample.contact_force = seen.contact_force;
    sample.contact_force_peak = std::max(contact_peak, seen.contact_force);
    sample.contact_load = seen.contact_load;
    sample.handle_force_peak = std::max(handle_peak, std::abs(seen.handle_force));
    sample.contact_count = seen.contact_count;
    if (recorder) recorder->note_sample(step_number(), sample);
    trial.samples.push_back(as_recorded(sample));
    contact_peak = 0.0;
    handle_peak = 0.0;
  }

  void note_input(const sim::HandleInput& input) {
    if (input.feed == last_input.feed && input.turn == last_input.turn) return;
    if (recorder) recorder->note_input(step_number() + 1, input);
    last_input = input;
  }

  void close_second() {
    if (recorder) recorder->close_second(step_number(), world, monitor.events());
  }

  void finish() {
    if (step_number() % kStepsPerSample != 0) take_sample();
    close_second();
    finished = true;
  }

  std::shared_ptr<const Scene> scene;  // shared: other trials run in the same vessel
  std::string exercise_id;
  sim::World world;
  ExerciseMonitor monitor;

  sim::HandleInput last_input;
  double contact_peak = 0.0;
  double handle_peak = 0.0;
  std::optional<SecondRecorder> recorder;  // absent: nothing is written down
  assessment::RecordedTrial trial;
  bool finished = false;
};

TrialRun::TrialRun(std::shared_ptr<const Scene> scene, const curricula::Exercise& exercise,
                   Recording recording)
    : parts_(std::make_unique<Parts>(std::move(scene), exercise, recording)) {}
TrialRun::~TrialRun() = default;

void TrialRun::step(const sim::HandleInput& input) {
  Parts& p = *parts_;
  if (p.finished) return;
  p.note_input(input);
  if (p.world.step(input) == sim::StepStatus::diverged) {
    p.monitor.end(assessment::EndReason::diverged, p.time());
    p.finish();
    return;
  }
  const sim::Observation& seen = p.world.observation();
  p.contact_peak = std::max(p.contact_peak, seen.contact_force);
  p.handle_peak = std::max(p.handle_peak, std::abs(seen.handle_force));
  p.monitor.observe(seen, input);

  if (seen.step % kStepsPerSample == 0) p.take_sample();
  if (p.monitor.task().ended) {
    p.finish();
  } else if (seen.step % kStepsPerSecond == 0) {
    p.close_second();
  }
}

bool TrialRun::ended() const { return parts_->finished; }

void TrialRun::abort() {
  if (parts_->finished) return;
  parts_->monitor.end(assessment::EndReason::aborted, parts_->time());
  parts_->finish();
}

void TrialRun::note_event(const char* code) { parts_->monitor.note(parts_->time(), code); }

const sim::World& TrialRun::world() const { return parts_->world; }
const ExerciseMonitor& TrialRun::monitor() const { return parts_->monitor; }

std::vector<RecordedSecond> TrialRun::take_recorded() {
  return parts_->recorder ? parts_->recorder->take() : std::vector<RecordedSecond>{};
}

assessment::RecordedTrial TrialRun::recorded_trial() const {
  const Parts& p = *parts_;
  assessment::RecordedTrial trial = p.trial;
  trial.exercise_id = p.exercise_id;
  trial.end_reason = p.monitor.task().end_reason;
  trial.steps = p.monitor.steps();
  trial.events = p.monitor.events();
  trial.end_time = p.time();
  return trial;
}

std::string TrialRun::state_hash() const {
  return parts_->recorder ? parts_->recorder->state_hash() : std::string();
}

std::string TrialRun::input_sha256() const {
  return parts_->recorder ? parts_->recorder->input_sha256() : std::string();
}

Judgement judge(const curricula::Exercise& exercise, const assessment::RecordedTrial& trial) {
  Judgement judgement;
  for (assessment::MetricValue& value : assessment::compute_metrics(trial)) {
    const bool wanted = std::find(exercise.record.begin(), exercise.record.end(), value.id) !=
                        exercise.record.end();
    if (wanted) judgement.metrics.push_back(std::move(value));
  }
  judgement.step_times = assessment::step_times(trial);
  if (exercise.pass) {
    std::vector<assessment::LimitBound> limits;
    for (const curricula::Limit& limit : exercise.limits) {
      limits.push_back({limit.metric, limit.comparison, limit.bound});
    }
    judgement.verdict = assessment::judge(*exercise.pass, trial, judgement.metrics, limits);
  }
  return judgement;
}

}  // namespace app
