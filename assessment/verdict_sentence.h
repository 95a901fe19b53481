// The one sentence a person reads after a trial.
//
//     Passed: 71.2 s, target 90 s, no critical error.
//     Not passed: 112.4 s is 22.4 s over the target of 90 s.
//     Not passed: peak contact force reached 2.31 N, above the limit of 2 N: a critical error.
//     Not counted: the trial was ended early, at 45.2 s, in step 2 of 3 (retract).
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "assessment/rule.h"

namespace assessment {

// `because`: positions in verdict.criteria of the criteria that decided it.
std::string verdict_sentence(const Verdict& verdict, std::span<const std::size_t> because,
                             const RecordedTrial& trial, std::span<const LimitBound> limits);

}  // namespace assessment
