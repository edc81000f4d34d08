#pragma once
// Exact sums and products of doubles (Shewchuk 1997): the last rung below error-bounded doubles.
// Slow, and rarely asked.
//
// Laws: every operation is exact while no product of components overflows or underflows (inputs
// within 1e-70..1e70 for the degrees used here); the rounding mode is to nearest.
#include <vector>

namespace overstrike {

/// The exact sum of its components, which do not overlap and grow in magnitude.
class Expansion {
 public:
  Expansion() = default;
  Expansion(double value) {  // NOLINT: a double is an expansion
    if (value != 0) parts_.push_back(value);
  }

  friend Expansion operator+(const Expansion& a, const Expansion& b);
  friend Expansion operator-(const Expansion& a, const Expansion& b) { return a + -b; }
  friend Expansion operator*(const Expansion& a, const Expansion& b);
  Expansion operator-() const;

  /// -1, 0 or 1.
  int sign() const { return parts_.empty() ? 0 : (parts_.back() > 0 ? 1 : -1); }
  /// The value to within an ulp or two.
  double approximate() const;

 private:
  void add(double value);
  void add_product(double a, double b);

  std::vector<double> parts_;
};

}  // namespace overstrike
