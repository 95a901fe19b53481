// Finds the word that was probably meant, for "did you mean".
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace curricula {

// The candidate fewest typing errors away from `word`, or empty when none is near enough for a
// sensible guess. Ties go to the candidate that comes first.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

}  // namespace curricula
