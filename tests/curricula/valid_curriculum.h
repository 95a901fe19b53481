// A small curriculum without problems, and a catalogue it fits, for tests that break one thing.
#pragma once

#include <stdexcept>
#include <string>

#include "curricula/check.h"

namespace test {

inline curricula::Catalogue small_catalogue() {
  return {{{"tube", 400.0}}, {{"wire", 1500.0}, {"short-wire", 300.0}}};
}

// Line numbers in the tests count from 1 at "schema:".
inline std::string valid_curriculum() {
  return R"(schema: cathedra-curriculum/1
id: small
version: 1.2.0
status: published
title: {en: "Small", de: "Klein"}
authors: ["somebody"]
defaults:
  attempt: {time_limit_s: 300, on_timeout: invalid, on_abort: fail}
  feedback: {during: [force], after: [time]}
benchmarks:
  quick:
    metric: time_s
    rule: {kind: fixed, provisional: true}
    value: 90
    reason: {en: "a guess"}
exercises:
  - id: feed
    version: 3
    title: {en: "Feed"}
    goal: {en: "Feed it."}
    scene: {anatomy: tube, instruments: [wire], start_mm: 50, seed: 9}
    steps:
      - {id: there, do: translate, to_mm: 300, tolerance_mm: 2, hold_s: 1}
      - {id: still, do: hold, seconds: 3}
      - {id: back, do: translate, to_mm: -50, tolerance_mm: 1}
    limits:
      - {metric: force_max_n, op: "<=", value: 1.5, on_breach: critical_error}
      - {metric: time_s, op: "<", value: 200, on_breach: mark}
    record: [time_s, force_max_n]
    pass: {all: [{metric: time_s, op: "<=", benchmark: quick}, {errors: critical, op: "==", value: 0}]}
    proficiency: {consecutive: 2, additional: 1, min_trials: 3, max_trials: 40}
  - id: turn
    version: 1
    title: {en: "Turn"}
    requires: {all: [{exercise: feed, state: proficient}]}
    scene: {anatomy: tube, instruments: [wire]}
    attempt: {time_limit_s: 60}
    feedback: {after: [metrics]}
    steps:
      - repeat: 2
        steps:
          - {id: cw, do: rotate, to_deg: 180, tolerance_deg: 5}
          - {id: ccw, do: rotate, to_deg: 0, tolerance_deg: 5, hold_s: 0.5}
    record: [time_s, reversals]
    pass: {any: [{not: {metric: reversals, op: ">", value: 4}}, {goal: reached}]}
    proficiency: {consecutive: 1}
plan:
  - {block: first, exercises: [feed], max_trials_per_day: 4}
  - {block: second, title: {en: "Second"}, exercises: [turn], order: listed, after: first, unlock: proficiency}
completion: {all_blocks: true, sign_off: instructor}
)";
}

// `text` with the first `from` replaced by `to`. The text must have it.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos)
    throw std::invalid_argument("the test replaces what is not there: " + from);
  return text.replace(at, from.size(), to);
}

}  // namespace test
