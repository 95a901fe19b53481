// Trials: begun before the first step, their trace written each second while they run, closed
// with metrics and a score. What a crash leaves open is closed as aborted at the next start.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/metrics.h"
#include "assessment/rule.h"
#include "assessment/trial.h"
#include "database/store.h"

namespace database {

struct NewTrial {
  std::string id;                     // UUIDv7, made by the caller (new_id())
  std::string person_id, enrolment_id;
  std::string exercise_id;            // linear
  std::string exercise_version_id;    // row
  assessment::Source source = assessment::Source::live;
  std::string dataset;                // "paper" for published data, else empty
  std::string apparatus;              // "cathedra", or the paper's own
  std::string device;                 // keyboard, simulated:expert, ...
  std::uint64_t seed = 0;
  std::string build, isa;
  std::string anatomy_sha256, instruments_sha256;
  std::string started_utc;            // empty: now
};

struct Chunk {
  int seq = 0;                        // 0, 1, ... one per second per kind
  std::string kind;                   // inputs | observed | hashes
  std::string codec;                  // name and version of the encoding
  std::vector<std::byte> bytes;
};

struct StoredTrial {
  NewTrial head;
  int ordinal = 0;                    // 1-based among the person's trials of this exercise id
  std::string ended_utc;              // empty while running
  std::optional<assessment::EndReason> end_reason;
  double paused_s = 0.0, slowed_s = 0.0;
  bool interrupted = false;
  std::string input_sha256, state_hash;  // hex
  std::string voided_utc, voided_by, void_reason;
  std::vector<assessment::MetricValue> metrics;
  std::optional<assessment::Outcome> outcome;     // of the latest score
  std::string person_name;            // display name, for lists
};

struct FinishedTrial {
  assessment::EndReason end_reason = assessment::EndReason::aborted;
  double paused_s = 0.0, slowed_s = 0.0, end_time_s = 0.0;
  bool interrupted = false;
  std::string input_sha256, state_hash;
  std::vector<assessment::TrialStep> steps;
  std::vector<assessment::MetricValue> metrics;
  assessment::Verdict verdict;
  std::string rule_version;           // exercise id@version that judged it
};

base::Result<int> begin_trial(Store& store, const NewTrial& trial);  // the ordinal
// What one second of a running trial left: chunks and events, in one transaction.
base::Status append_trace(Store& store, const std::string& trial_id, std::span<const Chunk> chunks,
                          std::span<const assessment::Event> events);
// Steps, metrics, score and end in one transaction, the last chunks with them.
base::Status finish_trial(Store& store, const std::string& trial_id, const FinishedTrial& finished,
                          std::span<const Chunk> chunks, std::span<const assessment::Event> events);
// Files a trial known only by its results (published data): metrics and end, no trace.
base::Status import_trial(Store& store, const NewTrial& trial,
                          std::span<const assessment::MetricValue> metrics);

base::Result<StoredTrial> trial(Store& store, const std::string& trial_id);  // not_found
base::Result<std::vector<Chunk>> trial_chunks(Store& store, const std::string& trial_id,
                                              const std::string& kind);      // by seq
base::Result<std::vector<assessment::Event>> trial_events(Store& store, const std::string& trial_id);
base::Result<std::vector<assessment::TrialStep>> trial_steps(Store& store, const std::string& trial_id);
base::Result<assessment::Verdict> trial_verdict(Store& store, const std::string& trial_id);  // latest score

struct TrialFilter {
  std::string person_id, exercise_id, dataset;     // empty: any
  std::optional<assessment::Source> source;
  bool finished_only = true;
};
// With metrics and outcome, ordered by person, exercise, ordinal.
base::Result<std::vector<StoredTrial>> trials(Store& store, const TrialFilter& filter);

// Closes what a killed program left running: end_reason aborted, up to its last chunk. How many.
base::Result<int> abort_unfinished_trials(Store& store);
base::Result<std::vector<std::string>> unfinished_trials(Store& store);

base::Status void_trial(Store& store, const std::string& trial_id, const std::string& reason,
                        const std::string& actor);

}  // namespace database
