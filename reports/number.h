// Numbers as people read them, and as programs do.
#pragma once

#include <string>

namespace reports {

// Fixed decimals, a true minus sign for negative values: "−6.22".
std::string fixed(double value, int decimals);

// Enough decimals for about three significant digits: 237.3, 12.4, 0.86, 0.083.
std::string plain(double value);

// Shortest text that reads back as the same number; dot decimals.
std::string exact(double value);

// A p value: two significant digits, never 0.
std::string p_text(double p);

}  // namespace reports
