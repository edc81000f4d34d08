#pragma once
// Sums and quotients in about twice the digits of a double, each with a bound of its error: between
// doubles and exact sums (expansion.h).
#include <cmath>
#include <limits>

#include "core/geometry/error_free.h"

namespace overstrike {

/// Law: the true value is within error() of value(). Valid where two_product is.
class SumOfTwo {
 public:
  SumOfTwo() = default;
  explicit SumOfTwo(double value) : hi_(value) {}

  double value() const { return hi_; }
  double error() const { return error_ + std::fabs(lo_); }

  friend SumOfTwo operator+(const SumOfTwo& a, const SumOfTwo& b) {
    const DoubleDouble s = two_sum(a.hi_, b.hi_);
    return {s.hi, s.lo + (a.lo_ + b.lo_),
            a.error_ + b.error_ + kStep * (std::fabs(s.lo) + std::fabs(a.lo_) + std::fabs(b.lo_))};
  }
  friend SumOfTwo operator-(const SumOfTwo& a, const SumOfTwo& b) {
    return a + SumOfTwo(-b.hi_, -b.lo_, b.error_);
  }
  friend SumOfTwo operator*(const SumOfTwo& a, const SumOfTwo& b) {
    const DoubleDouble p = two_product(a.hi_, b.hi_);
    const double cross = a.hi_ * b.lo_ + a.lo_ * b.hi_;
    const double size = std::fabs(a.hi_ * b.lo_) + std::fabs(a.lo_ * b.hi_) + std::fabs(p.lo);
    return {p.hi, p.lo + cross,
            kStep * size + std::fabs(a.lo_ * b.lo_) * 2 + a.error_ * (std::fabs(b.hi_) * 2) +
                b.error_ * (std::fabs(a.hi_) * 2 + a.error_)};
  }
  /// Infinitely unsure where the divisor may be 0.
  friend SumOfTwo operator/(const SumOfTwo& a, const SumOfTwo& b) {
    const double least = std::fabs(b.hi_) - std::fabs(b.lo_) - b.error_;
    if (!(least > 0)) return {0, 0, std::numeric_limits<double>::infinity()};
    const double q = a.hi_ / b.hi_;
    const SumOfTwo rest = a - SumOfTwo(q) * b;
    const double more = rest.hi_ / b.hi_;
    const SumOfTwo left = rest - SumOfTwo(more) * b;
    return {q, more, (std::fabs(left.hi_) + std::fabs(left.lo_) + left.error_) / least * 2};
  }

 private:
  SumOfTwo(double hi, double lo, double error) : error_(error) {
    const DoubleDouble s = two_sum(hi, lo);
    hi_ = s.hi, lo_ = s.lo;
  }

  /// Few roundings of numbers of the size it is multiplied with, and as much again for the
  /// roundings of the bound itself.
  static constexpr double kStep = 8 * 0x1p-53;
  double hi_ = 0, lo_ = 0, error_ = 0;
};

}  // namespace overstrike
