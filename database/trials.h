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
#include "database/people.h"
#include "database/store.h"

namespace database {

struct NewTrial {
  std::string id;  // UUIDv7, made by the caller (new_id())
  std::string person_id;
  std::string enrolment_id;         // of this person, or empty
  std::string exercise_id;          // linear
  std::string exercise_version_id;  // row, or empty (published data)
  assessment::Source source = assessment::Source::live;
  std::string dataset;    // "paper" for published data, else empty
  std::string apparatus;  // "cathedra", or the paper's own
  std::string device;     // keyboard, simulated:expert, ...
  std::uint64_t seed = 0;
  std::string build, isa;
  std::string anatomy_sha256, instruments_sha256;
  std::string started_utc;  // empty: now
};

struct Chunk {
  int seq = 0;        // 0, 1, ... one per second per kind
  std::string kind;   // inputs | observed | hashes
  std::string codec;  // name and version of the encoding
  std::vector<std::byte> bytes;
};

struct StoredTrial {
  NewTrial head;
  std::string curriculum_id;  // of the enrolment; empty without one
  int ordinal = 0;        // 1-based among the person's trials of this exercise id
  std::string ended_utc;  // empty while running
  std::optional<assessment::EndReason> end_reason;
  double paused_s = 0.0, slowed_s = 0.0;
  bool interrupted = false;
  std::string input_sha256, state_hash;  // hex
  std::string voided_utc, voided_by, void_reason;
  std::vector<assessment::MetricValue> metrics;
  std::optional<assessment::Outcome> outcome;  // of the latest score
  std::string person_name;                     // display name, for lists
  double end_time_s = 0.0;                     // simulated
  std::optional<Level> level;                  // of the person when the trial started
};

struct FinishedTrial {
  assessment::EndReason end_reason = assessment::EndReason::aborted;
  double paused_s = 0.0, slowed_s = 0.0, end_time_s = 0.0;
  bool interrupted = false;
  std::string input_sha256, state_hash;
  std::vector<assessment::TrialStep> steps;
  std::vector<assessment::MetricValue> metrics;
  assessment::Verdict verdict;
  std::string rule_version;  // exercise id@version that judged it
};

// The ordinal. not_found: person, exercise version, or enrolment of that person; conflict: the id.
base::Result<int> begin_trial(Store& store, const NewTrial& trial);
// What one second of a running trial left: chunks and events, in one transaction. conflict when
// the trial has ended or holds such a chunk already.
base::Status append_trace(Store& store, const std::string& trial_id, std::span<const Chunk> chunks,
                          std::span<const assessment::Event> events);
// Steps, metrics, score and end in one transaction, the last chunks with them.
base::Status finish_trial(Store& store, const std::string& trial_id, const FinishedTrial& finished,
                          std::span<const Chunk> chunks, std::span<const assessment::Event> events);
// Files a trial known only by its results (published data): metrics and end (completed, its
// end_time_s the metric time_s where there is one), no trace and no score.
base::Status import_trial(Store& store, const NewTrial& trial,
                          std::span<const assessment::MetricValue> metrics);

base::Result<StoredTrial> trial(Store& store, const std::string& trial_id);  // not_found
base::Result<std::vector<Chunk>> trial_chunks(Store& store, const std::string& trial_id,
                                              const std::string& kind);  // by seq
base::Result<std::vector<assessment::Event>> trial_events(Store& store,
                                                          const std::string& trial_id);
base::Result<std::vector<assessment::TrialStep>> trial_steps(Store& store,
                                                             const std::string& trial_id);
base::Result<assessment::Verdict> trial_verdict(Store& store,
                                                const std::string& trial_id);  // latest score

struct TrialFilter {
  std::string person_id, exercise_id, dataset;  // empty: any
  // Made under this curriculum, or under none (published data, which belongs to no curriculum).
  // Two curricula may have an exercise of one id; a trial of one does not count in the other.
  std::string curriculum_id;
  std::optional<assessment::Source> source;
  bool finished_only = true;
  bool with_metrics = true;  // false: leave them empty, and be quicker
  std::string only_metric;   // this one only; empty: all
};
// With metrics and outcome, ordered by person, exercise, ordinal. Two queries, however many.
base::Result<std::vector<StoredTrial>> trials(Store& store, const TrialFilter& filter);

// How far each person is in each exercise, for lists of people. One query, no trial is read.
struct TrialCount {
  std::string person_id, exercise_id;
  int started = 0;  // all, also running, interrupted and voided ones
  int passed = 0;   // passed, not voided, not interrupted
  std::string last_started_utc;
};
base::Result<std::vector<TrialCount>> trial_counts(Store& store);  // by person, exercise

// Closes what a killed program left running: end_reason aborted, interrupted, ended when its last
// chunk was written, its trace kept, judged invalid with a sentence. How many. Only for the start
// of the one program that runs live trials: it cannot tell a killed trial from a running one.
base::Result<int> abort_unfinished_trials(Store& store);
base::Result<std::vector<std::string>> unfinished_trials(Store& store);

// Takes a finished trial out of the counts, with a reason, and audits it; its end reason and score
// stay. conflict: still running, or voided already.
base::Status void_trial(Store& store, const std::string& trial_id, const std::string& reason,
                        const std::string& actor);

}  // namespace database
