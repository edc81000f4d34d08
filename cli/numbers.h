#pragma once
// Numbers on the command line: finite, whole words only, and an error that names the option.
#include <string_view>
#include <vector>

namespace overstrike {

/// An option's numbers: how many, between which bounds, and how --help names them.
struct NumberRule {
  std::string_view option;    ///< "--light"
  std::string_view expected;  ///< "AZ,EL in degrees, EL from -90 to 90"
  std::size_t count = 1;      ///< separated by commas
};

/// Throws UsageError: "--light: expected AZ,EL in degrees, found 'nan'".
std::vector<double> read_numbers(const NumberRule& rule, std::string_view text);
[[noreturn]] void refuse(const NumberRule& rule, std::string_view text);

/// One number, low < x <= high.
double read_number_above(const NumberRule& rule, std::string_view text, double low, double high);
/// One whole number, low <= x <= high.
int read_integer(const NumberRule& rule, std::string_view text, int low, int high);

}  // namespace overstrike
