// An exercise as the trainee sees it before starting.
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "assessment/rule.h"
#include "curricula/catalogue.h"
#include "curricula/curriculum.h"
#include "curricula/progression.h"

namespace app {

nlohmann::json briefing_json(const curricula::Curriculum& curriculum,
                             const curricula::Exercise& exercise,
                             const curricula::ExerciseState& state,
                             const curricula::Library& library);

// The leaf of the pass rule that bounds a metric from above; null when there is none.
const assessment::Rule* target_of(const curricula::Exercise& exercise, const std::string& metric);

// The leaf that bounds a metric from either side, as a metric of which more is better is; null when
// there is none.
const assessment::Rule* bound_of(const curricula::Exercise& exercise, const std::string& metric);

}  // namespace app
