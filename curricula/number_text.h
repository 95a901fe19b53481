// Numbers in sentences: 350, 0.5, 1.25 — without trailing zeros.
#pragma once

#include <string>

namespace curricula {

std::string number_text(double value);  // up to six significant digits, dot decimals

}  // namespace curricula
