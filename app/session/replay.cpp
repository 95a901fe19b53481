#include "app/session/replay.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "app/devices/recorded_operator.h"
#include "app/session/build_info.h"
#include "app/session/record_comparison.h"
#include "app/session/recording.h"
#include "app/session/trial_file.h"
#include "app/session/trial_run.h"
#include "database/trials.h"

namespace app {
namespace {

// What the database holds of one trial's trace, chunk by chunk.
struct StoredTrace {
  std::vector<database::Chunk> inputs, observed, hashes;
  std::vector<SecondHashes> seconds;  // decoded hashes
};

base::Result<StoredTrace> load_trace(database::Store& store, const std::string& trial_id) {
  StoredTrace trace;
  const std::pair<const char*, std::vector<database::Chunk>*> parts[] = {
      {"inputs", &trace.inputs}, {"observed", &trace.observed}, {"hashes", &trace.hashes}};
  for (const auto& [kind, chunks] : parts) {
    auto loaded = database::trial_chunks(store, trial_id, kind);
    if (!loaded) return loaded.error();
    *chunks = *std::move(loaded);
  }
  if (trace.hashes.empty()) {
    return base::Error{base::ErrorCode::not_enough_data,
                       "this trial has no trace to replay: it is known by its results only"};
  }
  return trace;
}

// Second `seq` ends with one of the steps 1000 seq + 1 ... 1000 (seq + 1), or with 1000 seq when
// the trial was given up right there.
bool lies_in_second(std::uint32_t step, int seq) {
  const auto first = static_cast<std::int64_t>(seq) * kStepsPerSecond;
  return step >= first && step <= first + kStepsPerSecond;
}

// What is wrong with second `k` of the trace: the kind of its chunk that is missing or was changed.
const char* changed_kind(StoredTrace& trace, std::size_t k) {
  const auto seq = static_cast<int>(k);
  const auto missing = [&](const std::vector<database::Chunk>& chunks) {
    return k >= chunks.size() || chunks[k].seq != seq;
  };
  if (missing(trace.hashes)) return "hashes";
  if (missing(trace.inputs)) return "inputs";
  if (missing(trace.observed)) return "observed";
  const auto decoded = read_hashes(trace.hashes[k].bytes);
  if (!decoded || decoded->size() != 1 || !lies_in_second(decoded->front().step, seq)) {
    return "hashes";
  }
  if (decoded->front().inputs != hash_of(trace.inputs[k].bytes)) return "inputs";
  if (decoded->front().observed != hash_of(trace.observed[k].bytes)) return "observed";
  trace.seconds.push_back(decoded->front());
  return nullptr;
}

// The first chunk that is missing or whose bytes are not the ones hashed when it was written.
void find_changed_chunk(StoredTrace& trace, Verification& result) {
  const std::size_t count =
      std::max({trace.hashes.size(), trace.inputs.size(), trace.observed.size()});
  for (std::size_t k = 0; k < count; ++k) {
    if (const char* changed = changed_kind(trace, k)) {
      result.chunk = std::string(changed) + " " + std::to_string(k);
      result.first_second = static_cast<int>(k);
      return;
    }
  }
}

// The inputs of the chunks before the first that cannot be read.
std::vector<InputChange> readable_inputs(const StoredTrace& trace) {
  std::vector<InputChange> changes;
  for (const database::Chunk& chunk : trace.inputs) {
    const auto read = read_inputs(chunk.bytes);
    if (!read) break;
    changes.insert(changes.end(), read->begin(), read->end());
  }
  return changes;
}

double deviation(const assessment::Sample& a, const assessment::Sample& b) {
  return std::hypot(a.tip[0] - b.tip[0], a.tip[1] - b.tip[1], a.tip[2] - b.tip[2]);
}

// What a replay stands on: the exercise and scene of the time, checked to be the same files.
struct Setting {
  database::StoredTrial trial;
  curricula::Exercise exercise;
  // shared: with other trials in the same vessel
  std::shared_ptr<const Scene> scene;
};

base::Result<Setting> setting_of(database::Store& store, const std::string& trial_id,
                                 SceneStore& scenes) {
  const auto stored = database::trial(store, trial_id);
  if (!stored) return stored.error();
  const auto exercise = exercise_of(store, *stored, scenes.library().catalogue());
  if (!exercise) return exercise.error();
  const auto scene = scenes.scene(exercise->scene);
  if (!scene) return scene.error();
  if ((*scene)->anatomy_sha256 != stored->head.anatomy_sha256 ||
      (*scene)->instruments_sha256 != stored->head.instruments_sha256) {
    return base::Error{base::ErrorCode::conflict,
                       "the anatomy or instrument file was changed since this trial was recorded; "
                       "restore the file of that time to replay it"};
  }
  return Setting{*stored, *exercise, *scene};
}

// Steps the run with the recorded hand up to the recorded end.
void play(TrialRun& run, RecordedOperator hand, std::uint32_t last_step,
          const std::function<void(double)>& progress) {
  while (!run.ended() && run.world().observation().step < last_step) {
    run.step(hand.next(run.world().observation(), run.monitor()));
    const std::int64_t step = run.world().observation().step;
    if (step % kStepsPerSecond == 0 && progress) {
      progress(static_cast<double>(step) / static_cast<double>(last_step));
    }
  }
  if (!run.ended()) run.abort();
}

std::uint32_t last_step_of(const StoredTrace& trace) {
  return trace.seconds.empty() ? 0 : trace.seconds.back().step;
}

// Second by second: the state, everything observed, and how far the tip was from the record.
void compare_seconds(const StoredTrace& trace, const std::vector<RecordedSecond>& replayed,
                     Verification& result) {
  const std::size_t count = std::min(trace.seconds.size(), replayed.size());
  for (std::size_t k = 0; k < count; ++k) {
    const auto there = read_samples(trace.observed[k].bytes);
    const auto here = read_samples(replayed[k].observed);
    for (std::size_t i = 0; there && here && i < std::min(there->size(), here->size()); ++i) {
      result.largest_deviation_mm =
          std::max(result.largest_deviation_mm, deviation((*there)[i], (*here)[i]));
    }
    const auto hashes = read_hashes(replayed[k].hashes);
    const bool same = hashes && hashes->front().step == trace.seconds[k].step &&
                      hashes->front().state == trace.seconds[k].state &&
                      replayed[k].observed == trace.observed[k].bytes;
    if (!same && (!result.first_second || replayed[k].seq < *result.first_second)) {
      result.first_second = replayed[k].seq;
    }
  }
  if (count < trace.seconds.size() && !result.first_second) {
    result.first_second = static_cast<int>(count);  // the replay ended before the record did
  }
  result.seconds = static_cast<int>(count);
}

// A crash cut it off before it was judged: nothing but the trace is there to compare.
bool was_cut_off(const database::StoredTrial& trial) {
  return trial.end_reason == assessment::EndReason::aborted && trial.state_hash.empty() &&
         trial.input_sha256.empty() && trial.metrics.empty();
}

std::string verdict_sentence(const Verification& result, const std::string& build) {
  if (result.confirmed) {
    return "Confirmed: the replay gave the same state and observations in each of the " +
           std::to_string(result.seconds) + " recorded seconds, " +
           (result.cut_off ? "up to where the trial was cut off; it was never judged."
                           : "and the same steps, events, metrics and verdict.");
  }
  if (result.chunk.empty() && !result.same_build) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "Not compared bit for bit: recorded by build %s, this is %s. The largest "
                  "deviation of the tip is %.6f mm.",
                  build.c_str(), build_id().c_str(), result.largest_deviation_mm);
    return text;
  }
  std::string text = "Not confirmed: ";
  if (!result.chunk.empty())
    text += "the stored chunk \"" + result.chunk + "\" was changed or is missing; ";
  if (result.first_second) {
    text += "the first second that differs is " + std::to_string(*result.first_second) + " (" +
            std::to_string(*result.first_second) + " to " +
            std::to_string(*result.first_second + 1) + " s).";
  } else {
    text += "what the database holds of " + result.differs +
            " is not what the replay of the inputs gives.";
  }
  return text;
}

}  // namespace

base::Result<Verification> verify_trial(database::Store& store, const std::string& trial_id,
                                        SceneStore& scenes,
                                        const std::function<void(double)>& progress) {
  const auto setting = setting_of(store, trial_id, scenes);
  if (!setting) return setting.error();
  auto loaded = load_trace(store, trial_id);
  if (!loaded) return loaded.error();
  StoredTrace trace = *std::move(loaded);

  Verification result;
  result.same_build = setting->trial.head.build == build_id();
  find_changed_chunk(trace, result);

  TrialRun run(setting->scene, setting->exercise);
  play(run, RecordedOperator(readable_inputs(trace)), last_step_of(trace), progress);
  compare_seconds(trace, run.take_recorded(), result);

  result.cut_off = was_cut_off(setting->trial);
  if (!result.cut_off) {
    const auto differs = difference_from_record(store, setting->trial, setting->exercise, run);
    if (!differs) return differs.error();
    result.differs = *differs;
  }
  result.confirmed = result.chunk.empty() && !result.first_second && result.differs.empty();
  result.sentence = verdict_sentence(result, setting->trial.head.build);
  return result;
}

base::Result<assessment::RecordedTrial> replay_trial(database::Store& store,
                                                     const std::string& trial_id,
                                                     SceneStore& scenes,
                                                     const std::function<void(double)>& progress) {
  const auto setting = setting_of(store, trial_id, scenes);
  if (!setting) return setting.error();
  auto trace = load_trace(store, trial_id);
  if (!trace) return trace.error();
  std::uint32_t last_step = 0;
  for (const database::Chunk& chunk : trace->hashes) {
    const auto hashes = read_hashes(chunk.bytes);
    if (!hashes) return hashes.error();
    for (const SecondHashes& second : *hashes) {
      if (lies_in_second(second.step, chunk.seq)) last_step = std::max(last_step, second.step);
    }
  }
  TrialRun run(setting->scene, setting->exercise);
  play(run, RecordedOperator(readable_inputs(*trace)), last_step, progress);
  return run.recorded_trial();
}

}  // namespace app
