// Which program this is: a trial stores it, because only the same build promises the same trial
// bit for bit.
#pragma once

#include <string>

namespace app {

inline constexpr const char* kVersion = "0.1.0";
inline constexpr const char* kInstructionSet = "x86-64-baseline";

// The version and the first twelve digits of the program file's SHA-256: "0.1.0+3f2a...".
// Worked out once per process.
const std::string& build_id();

}  // namespace app
