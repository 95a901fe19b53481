// A curriculum: a versioned plan of exercises, as read from one YAML file. Angles here are what
// the program computes in (rad); the file says degrees.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assessment/proficiency.h"
#include "assessment/rule.h"
#include "assessment/trial.h"

namespace curricula {

using Text = std::map<std::string, std::string>;  // language -> text, "en" always present

// A step as written; repeat has children.
struct Step {
  enum class Kind { translate, rotate, hold, repeat };
  std::string id;
  Kind kind = Kind::translate;
  double target = 0.0;      // translate: mm, rotate: rad; cumulative from the start of the trial
  double tolerance = 0.0;   // mm or rad; hold: mm the handle may move (rad/100 likewise)
  double hold = 0.0;        // s the handle must stay within the tolerance
  double seconds = 0.0;     // hold: how long
  int times = 1;            // repeat
  std::vector<Step> steps;  // repeat

  bool operator==(const Step&) const = default;
};

enum class Consequence { mark, fail, critical_error, stop };

struct Limit {
  std::string metric;  // a metric that only grows during a trial: force_max_n, ...
  assessment::Comparison comparison = assessment::Comparison::less_equal;
  double bound = 0.0;
  Consequence on_breach = Consequence::mark;

  bool operator==(const Limit&) const = default;
};

struct Scene {
  std::string anatomy;
  std::vector<std::string> instruments;
  double start = 0.0;  // mm inserted at the start
  std::uint64_t seed = 0;

  bool operator==(const Scene&) const = default;
};

struct Attempt {
  double time_limit = 900.0;  // s, simulated
  bool timeout_fails = true;  // false: a timed-out trial is invalid
  bool abort_fails = false;   // false: an aborted trial is invalid

  bool operator==(const Attempt&) const = default;
};

struct Exercise {
  std::string id;
  int version = 1;
  Text title;
  Text goal;  // what to do and why; may be empty
  Scene scene;
  std::vector<Step> steps;
  std::vector<Limit> limits;
  Attempt attempt;
  std::vector<std::string> record;       // metric ids
  std::optional<assessment::Rule> pass;  // benchmarks already resolved into bounds
  std::optional<assessment::ProficiencyRule> proficiency;
  std::vector<std::string> requires_proficient;  // exercise ids
  std::vector<std::string> feedback_during, feedback_after;
  std::string yaml;  // the exercise's own text, as stored with the version
  int line = 0;      // of the file, where it begins; 1-based
};

// Where a pass mark comes from. Only `fixed` ones have a value; the others name the data that will
// give them one and cannot be passed by yet.
struct Benchmark {
  std::string id;
  std::string metric;
  std::string rule;  // fixed | mean_plus_k_sd | percentile | contrasting_groups
  bool provisional = false;
  double value = 0.0;  // in the metric's unit
  Text reason;
  std::string cohort, apparatus;  // of the data; empty when the file names none
  int min_participants = 0;

  bool operator==(const Benchmark&) const = default;
};

struct Block {
  std::string id;
  Text title;  // empty: shown by its id
  std::vector<std::string> exercises;
  bool any_order = true;
  int max_trials_per_day = 0;  // 0: no limit
  std::string after;           // id of the block that must be proficient first, or empty

  bool operator==(const Block&) const = default;
};

enum class Lifecycle { draft, published, retired };

struct Curriculum {
  std::string id;
  std::string version;  // semantic
  Lifecycle status = Lifecycle::draft;
  Text title;
  std::vector<std::string> authors;
  std::vector<Benchmark> benchmarks;
  std::vector<Exercise> exercises;
  std::vector<Block> plan;
  std::string sha256;  // of the file's bytes, hex
  std::string yaml;    // the file's bytes

  const Exercise* find(const std::string& exercise_id) const;  // null when unknown
};

// The steps with every repeat unrolled, in the order they are done. Steps inside a repeat get the
// round as a suffix: cw.1, ccw.1, cw.2, ...
std::vector<Step> unroll(const std::vector<Step>& steps);

// "Feed to 350 mm", "Retract to 150 mm", "Turn to 0 degrees": what the step asks, for the screen.
// `from` is the handle position before the step, mm; it tells feeding from retracting.
std::string describe(const Step& step, double from = 0.0);

// The same for every step of unroll(), each seen from where the step before left the handle:
// "Feed to 350 mm", "Retract to 150 mm".
std::vector<std::string> describe_all(const std::vector<Step>& unrolled);

}  // namespace curricula
