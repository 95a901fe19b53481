#include "app/session/trial_file.h"

#include <utility>
#include <vector>

#include "app/session/build_info.h"
#include "app/session/recording.h"
#include "curricula/check.h"
#include "database/curricula.h"

namespace app {
namespace {

struct Pieces {
  std::vector<database::Chunk> chunks;
  std::vector<assessment::Event> events;
};

Pieces pieces_of(std::span<const RecordedSecond> seconds) {
  Pieces pieces;
  for (const RecordedSecond& second : seconds) {
    pieces.chunks.push_back({second.seq, "inputs", kInputsCodec, second.inputs});
    pieces.chunks.push_back({second.seq, "observed", kObservedCodec, second.observed});
    pieces.chunks.push_back({second.seq, "hashes", kHashesCodec, second.hashes});
    pieces.events.insert(pieces.events.end(), second.events.begin(), second.events.end());
  }
  return pieces;
}

assessment::RecordedTrial recorded_of(const TrialRun& run, const WallTime& wall) {
  assessment::RecordedTrial recorded = run.recorded_trial();
  recorded.paused = wall.paused;
  recorded.slowed = wall.slowed;
  return recorded;
}

}  // namespace

bool is_interrupted(const WallTime& wall, double simulated) {
  return wall.longest_pause > 5.0 || wall.slowed > 0.02 * simulated;
}

base::Result<BegunTrial> begin(database::Store& store, const TrialHead& head, const Scene& scene) {
  const auto enrolment = database::enrol(store, head.person_id, head.curriculum_id);
  if (!enrolment) return enrolment.error();
  const auto version = database::current_exercise(store, head.curriculum_id, head.exercise_id);
  if (!version) return version.error();

  database::NewTrial trial;
  trial.id = database::new_id();
  trial.person_id = head.person_id;
  trial.enrolment_id = *enrolment;
  trial.exercise_id = head.exercise_id;
  trial.exercise_version_id = version->id;
  trial.source = head.source;
  trial.apparatus = "cathedra";
  trial.device = head.device;
  trial.seed = head.seed;
  trial.build = build_id();
  trial.isa = kInstructionSet;
  trial.anatomy_sha256 = scene.anatomy_sha256;
  trial.instruments_sha256 = scene.instruments_sha256;
  const auto ordinal = database::begin_trial(store, trial);
  if (!ordinal) return ordinal.error();
  return BegunTrial{trial.id, *ordinal};
}

base::Status append(database::Store& store, const std::string& trial_id,
                    std::span<const RecordedSecond> seconds) {
  if (seconds.empty()) return base::Done{};
  const Pieces pieces = pieces_of(seconds);
  return database::append_trace(store, trial_id, pieces.chunks, pieces.events);
}

Judgement judge(const curricula::Exercise& exercise, const TrialRun& run, const WallTime& wall) {
  return judge(exercise, recorded_of(run, wall));
}

base::Result<Judgement> finish(database::Store& store, const std::string& trial_id, TrialRun& run,
                               const curricula::Exercise& exercise, const WallTime& wall) {
  const assessment::RecordedTrial recorded = recorded_of(run, wall);
  Judgement judgement = judge(exercise, recorded);

  database::FinishedTrial finished;
  finished.end_reason = recorded.end_reason;
  finished.paused_s = wall.paused;
  finished.slowed_s = wall.slowed;
  finished.end_time_s = recorded.end_time;
  finished.interrupted = is_interrupted(wall, recorded.end_time);
  finished.input_sha256 = run.input_sha256();
  finished.state_hash = run.state_hash();
  finished.steps = recorded.steps;
  finished.metrics = judgement.metrics;
  finished.verdict = judgement.verdict;
  finished.rule_version = exercise.id + "@" + std::to_string(exercise.version);

  const std::vector<RecordedSecond> rest = run.take_recorded();
  const Pieces pieces = pieces_of(rest);
  const base::Status filed =
      database::finish_trial(store, trial_id, finished, pieces.chunks, pieces.events);
  if (!filed) return filed.error();
  return judgement;
}

base::Result<assessment::RecordedTrial> load_recorded(database::Store& store,
                                                      const std::string& trial_id) {
  const auto stored = database::trial(store, trial_id);
  if (!stored) return stored.error();
  auto chunks = database::trial_chunks(store, trial_id, "observed");
  if (!chunks) return chunks.error();
  auto steps = database::trial_steps(store, trial_id);
  if (!steps) return steps.error();
  auto events = database::trial_events(store, trial_id);
  if (!events) return events.error();

  assessment::RecordedTrial trial;
  trial.exercise_id = stored->head.exercise_id;
  trial.source = stored->head.source;
  trial.end_reason = stored->end_reason.value_or(assessment::EndReason::aborted);
  trial.paused = stored->paused_s;
  trial.slowed = stored->slowed_s;
  trial.steps = *std::move(steps);
  trial.events = *std::move(events);
  for (const database::Chunk& chunk : *chunks) {
    const auto samples = read_samples(chunk.bytes);
    if (!samples) return samples.error();
    trial.samples.insert(trial.samples.end(), samples->begin(), samples->end());
  }
  if (!trial.samples.empty()) trial.end_time = trial.samples.back().time;
  return trial;
}

base::Result<curricula::Exercise> exercise_of(database::Store& store,
                                              const database::StoredTrial& trial,
                                              const curricula::Catalogue& catalogue) {
  const auto versions = database::curriculum_versions(store);
  if (!versions) return versions.error();
  for (const database::CurriculumVersion& version : *versions) {
    for (const database::ExerciseVersion& exercise : version.exercises) {
      if (exercise.id != trial.head.exercise_version_id) continue;
      const curricula::CheckResult checked = curricula::check(version.yaml, catalogue);
      const curricula::Exercise* found =
          checked.ok() ? checked.curriculum->find(exercise.exercise_id) : nullptr;
      if (found) return *found;
    }
  }
  return base::Error{base::ErrorCode::not_found,
                     "the exercise version this trial was made under is not in the database"};
}

}  // namespace app
