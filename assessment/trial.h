// The recorded trial: the contract between simulation and assessment. Everything a metric may
// look at is here; a metric never sees the running simulation.
//
// Units: mm, N, s, rad. Samples are at a fixed rate (100 Hz), the first at time 0.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace assessment {

inline constexpr double kSampleRate = 100.0;  // Hz

// One instrument at one instant.
struct Sample {
  double time = 0.0;                      // s, simulated, since the start of the trial
  std::array<double, 3> tip{};            // mm, patient frame
  std::array<double, 3> tip_direction{};  // unit
  double handle_axial = 0.0;              // mm, cumulative
  double handle_rotation = 0.0;           // rad, cumulative, unwrapped
  double inserted_length = 0.0;           // mm
  double handle_force = 0.0;              // N
  double handle_torque = 0.0;             // N mm
  double contact_force = 0.0;             // N, largest |sum of wall reactions| over any 6 mm
  double contact_force_peak = 0.0;        // N, its maximum over the steps since the sample before
  double contact_load = 0.0;              // N, sum of normal loads
  double handle_force_peak = 0.0;         // N, largest |handle_force| since the sample before
  std::int32_t contact_count = 0;
};

enum class Severity { info, mark, fail, critical };

struct Event {
  double time = 0.0;  // s
  std::string code;   // step_started, step_done, limit_breached, paused, resumed, timeout, ...
  Severity severity = Severity::info;
  std::string detail;  // id of the step, metric of the limit, ...
  double value = 0.0;  // residual of the step, value at the breach, ...
};

enum class StepKind { translate, rotate, hold };

// One step of the exercise (repeats are unrolled: cw.1, ccw.1, cw.2, ...) as it went.
struct TrialStep {
  std::string id;
  StepKind kind = StepKind::translate;
  double target = 0.0;     // mm or rad, cumulative handle position; hold: s
  double tolerance = 0.0;  // mm or rad
  double started = 0.0;    // s
  double ended = -1.0;     // s, negative while not done
  double residual = 0.0;   // handle minus target when it ended, mm or rad
  bool done() const { return ended >= 0.0; }
};

enum class EndReason { completed, timeout, limit, aborted, diverged };
enum class Source { live, imported, simulated_operator, published_data };

struct RecordedTrial {
  std::string exercise_id;
  EndReason end_reason = EndReason::aborted;
  Source source = Source::live;
  double start_axial = 0.0;  // mm, handle position at time 0
  std::vector<Sample> samples;
  std::vector<TrialStep> steps;  // in order, as unrolled
  std::vector<Event> events;
  double paused = 0.0;    // s of wall time
  double slowed = 0.0;    // s of wall time beyond simulated time
  double end_time = 0.0;  // s, simulated
};

// The words stored and shown for the enumerations; parse returns false on an unknown word.
const char* word(EndReason reason);
const char* word(Source source);
const char* word(Severity severity);
const char* word(StepKind kind);
bool parse(const std::string& text, EndReason& reason);
bool parse(const std::string& text, Source& source);
bool parse(const std::string& text, Severity& severity);
bool parse(const std::string& text, StepKind& kind);

}  // namespace assessment
