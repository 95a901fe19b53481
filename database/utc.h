// Times as stored: UTC, ISO 8601 with milliseconds and Z, so that sorting as text sorts by time.
#pragma once

#include <string>

#include "sim/base/result.h"

namespace database {

// Before any time there is: for what is true of a person without a date.
inline constexpr const char* kAlwaysUtc = "0001-01-01T00:00:00.000Z";

// The stored form of a time given as YYYY-MM-DDTHH:MM:SS[.fraction]Z; empty gives now. Fails with
// invalid_input.
base::Result<std::string> stored_utc(const std::string& text);

}  // namespace database
