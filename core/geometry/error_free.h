#pragma once
// Sums and products of doubles without error: the rounded result and what rounding lost.
// T. J. Dekker, A floating-point technique for extending the available precision, 1971; D. E.
// Knuth, The Art of Computer Programming, vol. 2, 4.2.2. Valid in round-to-nearest while nothing
// overflows and no product falls below 2^-969 (its error would be subnormal).

namespace overstrike {

/// An unevaluated sum: `hi` is hi + lo rounded to a double.
struct DoubleDouble {
  double hi, lo;
};

/// hi + lo == a + b exactly.
constexpr DoubleDouble two_sum(double a, double b) {
  const double hi = a + b;
  const double from_b = hi - a;
  return {hi, (a - (hi - from_b)) + (b - from_b)};
}

/// The same in fewer steps; |a| >= |b| or a == 0.
constexpr DoubleDouble fast_two_sum(double a, double b) {
  const double hi = a + b;
  return {hi, b - (hi - a)};
}

/// Upper 26 bits and the rest of a double below 2^996.
constexpr DoubleDouble split_bits(double a) {
  const double c = 134217729.0 * a;  // 2^27 + 1
  const double hi = c - (c - a);
  return {hi, a - hi};
}

/// hi + lo == a * b exactly.
constexpr DoubleDouble two_product(double a, double b) {
  const double hi = a * b;
  const DoubleDouble x = split_bits(a), y = split_bits(b);
  return {hi, ((x.hi * y.hi - hi) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
}

}  // namespace overstrike
