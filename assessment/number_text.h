// Numbers in sentences: short, but never so short that the sentence says the opposite of the
// verdict.
#pragma once

#include <string>
#include <string_view>

namespace assessment {

// The fewest digits that give exactly this number: "90", "0.1".
std::string exact_text(double value);

// With the decimals usual for the unit, trailing zeros dropped: 112.4 (s), 2.31 (N), 0.93 (a
// ratio).
std::string rounded_text(double value, std::string_view unit);

// The same, but with as many more decimals as it takes to fall on the same side of `bound`:
// 90.0004 over a bound of 90 is not printed as 90.
std::string text_beside(double value, double bound, std::string_view unit);

// How far `value` lies from `bound`, as anyone would compute it from the two texts above.
std::string distance_text(double value, double bound, std::string_view unit);

}  // namespace assessment
