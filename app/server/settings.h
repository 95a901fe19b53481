// What a person sets for the own browser: how fast the handle moves, keys, units, theme.
#pragma once

#include <nlohmann/json.hpp>

#include "sim/base/result.h"

namespace app {

// The wire's Settings, for who has set nothing.
nlohmann::json default_settings();
// The settings as they are stored, from what a browser sent. Fails with invalid_input.
base::Result<nlohmann::json> read_settings(const nlohmann::json& body);

}  // namespace app
