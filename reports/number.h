// Numbers as people read them, and as programs do.
#pragma once

#include <string>
#include <vector>

namespace reports {

// Fixed decimals, a true minus sign for negative values: "−6.22".
std::string fixed(double value, int decimals);

// Enough decimals for about three significant digits: 237.3, 12.4, 0.86, 0.083.
std::string plain(double value);
int plain_decimals(double value);  // how many that are

// The fewest decimals, at most `most`, that show every one of these numbers as it is: a column or
// an axis is printed with one number of them.
int common_decimals(const std::vector<double>& values, int most = 9);

// Shortest text that reads back as the same number; dot decimals.
std::string exact(double value);

// A p value: two significant digits, never 0, and never a rounding onto the wrong side of 0.05:
// "0.10", "0.029", "0.0496", "< 0.0001".
std::string p_text(double p);
std::string p_statement(double p);  // "p = 0.10", "p < 0.0001"

// However small, with its power of ten: "0.029", "7.4 × 10⁻⁷". A power alone: "10⁻⁷", "0.001".
std::string small_text(double value);
std::string power_of_ten_text(int exponent);

}  // namespace reports
