#pragma once
// Two numbers to compute one formula with: a double that knows its error, and an exact one.
//
// Every quantity whose sign the oracle needs is a polynomial of doubles (denominators are kept
// apart, as homogeneous coordinates), so that dyadic numbers hold it exactly. A formula is written
// once, as a template, and climbs from Approx to Exact only when the former cannot tell the sign.
#include <gmpxx.h>

#include <cmath>

namespace overstrike::oracle {

/// A value known to within `error`.
struct Approx {
  double value = 0, error = 0;
  Approx() = default;
  explicit Approx(double v) : value(v) {}
  Approx(double v, double e) : value(v), error(e) {}
  double low() const { return std::nextafter(value - error, -INFINITY); }
  double high() const { return std::nextafter(value + error, INFINITY); }
};

/// Half a unit in the last place of 1: what one rounded operation may be off, relatively.
constexpr double kHalfUlp = 0x1p-53;
/// Each error sum below is at most five roundings itself: (1 + u)^5 < 1 + 8u.
constexpr double kErrorSlack = 1 + 8 * kHalfUlp;
/// Above what a product or quotient can lose to underflow (2^-1074 and its multiples).
constexpr double kUnderflow = 0x1p-1000;

inline Approx operator-(const Approx& a) { return {-a.value, a.error}; }
inline Approx operator+(const Approx& a, const Approx& b) {
  const double v = a.value + b.value;
  return {v, (a.error + b.error + kHalfUlp * std::fabs(v)) * kErrorSlack};
}
inline Approx operator-(const Approx& a, const Approx& b) { return a + -b; }
inline Approx operator*(const Approx& a, const Approx& b) {
  const double v = a.value * b.value;
  const double e = std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error +
                   kHalfUlp * std::fabs(v);
  return {v, (e + kUnderflow) * kErrorSlack};
}
/// Infinite error where the divisor may be zero.
inline Approx operator/(const Approx& a, const Approx& b) {
  const double least = (std::fabs(b.value) - b.error) * (1 - 4 * kHalfUlp);
  if (!(least > 0)) return {0, INFINITY};
  const double v = a.value / b.value;
  const double e = (a.error + std::fabs(v) * b.error) / least + kHalfUlp * std::fabs(v);
  return {v, (e + kUnderflow) * kErrorSlack};
}

/// mantissa * 2^exponent, in full.
class Exact {
 public:
  Exact() = default;
  explicit Exact(double v) {
    constexpr int kMantissaBits = 53;
    mantissa_ = std::ldexp(std::frexp(v, &exponent_), kMantissaBits);
    exponent_ -= kMantissaBits;
  }
  int sign() const { return sgn(mantissa_); }

  friend Exact operator-(const Exact& a) { return {-a.mantissa_, a.exponent_}; }
  friend Exact operator*(const Exact& a, const Exact& b) {
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }
  friend Exact operator+(const Exact& a, const Exact& b) {
    if (a.exponent_ < b.exponent_) return b + a;
    const mpz_class shifted = a.mantissa_ << static_cast<unsigned>(a.exponent_ - b.exponent_);
    return {shifted + b.mantissa_, b.exponent_};
  }
  friend Exact operator-(const Exact& a, const Exact& b) { return a + -b; }

 private:
  Exact(const mpz_class& m, int e) : mantissa_(m), exponent_(sgn(m) == 0 ? 0 : e) {}
  mpz_class mantissa_;
  int exponent_ = 0;
};

/// The sign (-1, 0, 1) of formula.operator()<T>(), decided by Approx where it can.
template <class Formula>
int sign_of(const Formula& formula) {
  const Approx a = formula.template operator()<Approx>();
  if (a.value > a.error) return 1;
  if (a.value < -a.error) return -1;
  return formula.template operator()<Exact>().sign();
}

}  // namespace overstrike::oracle
