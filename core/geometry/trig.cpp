#include "core/geometry/trig.h"

#include <cmath>
#include <limits>
#include <utility>

#include "core/geometry/error_free.h"

namespace overstrike {
namespace {

// pi/180, 180/pi and sqrt(3)/2, sqrt(1/2) to twice the precision of a double.
constexpr DoubleDouble kRadians{0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};
constexpr DoubleDouble kDegrees{0x1.ca5dc1a63c1f8p+5, -0x1.1e7ab456405f9p-49};
constexpr DoubleDouble kCos30{0x1.bb67ae8584caap-1, 0x1.cec95d0b5c1e3p-55};
constexpr DoubleDouble kCos45{0x1.6a09e667f3bcdp-1, -0x1.bdd3413b26456p-55};

/// Below this angle or ratio the cube in the series is under 2^-60 of the first term.
constexpr double kLinear = 0x1p-30;

/// Taylor coefficients of (sin t - t) / t^3 and (cos t - 1 + t^2/2) / t^4 in t^2. For t <= pi/4 the
/// first terms left out are below 1e-19 and 4e-21.
constexpr double kSine[] = {
    -1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
    -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
constexpr double kCosine[] = {
    1.0 / 24,        -1.0 / 720,         1.0 / 40320,          -1.0 / 3628800,
    1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000, -1.0 / 6402373705728000};

/// Odd polynomial for the arc tangent on [0, 1], good to 1e-5 (Abramowitz and Stegun 4.4.47): one
/// step of tangents makes 16 digits of it.
constexpr double kArcTangent[] = {0.9998660, -0.3302995, 0.1801410, -0.0851330, 0.0208351};

template <int N>
double polynomial(const double (&coefficients)[N], double x) {
  double sum = coefficients[N - 1];
  for (int i = N - 2; i >= 0; --i) sum = sum * x + coefficients[i];
  return sum;
}

DoubleDouble radians(double degrees) {
  if (degrees < 0x1p-900) return {degrees * kRadians.hi, 0};  // too small to have exact errors
  const DoubleDouble p = two_product(degrees, kRadians.hi);
  return fast_two_sum(p.hi, p.lo + degrees * kRadians.lo);
}

/// For 0 <= degrees <= 45.
DoubleDouble sine_of_octant(double degrees) {
  if (degrees == 30) return {0.5, 0};
  if (degrees == 45) return kCos45;
  const DoubleDouble t = radians(degrees);
  const double z = t.hi * t.hi;
  return fast_two_sum(t.hi, t.hi * z * polynomial(kSine, z) + t.lo * (1 - 0.5 * z));
}

/// For 0 <= degrees <= 45.
DoubleDouble cosine_of_octant(double degrees) {
  if (degrees == 30) return kCos30;
  if (degrees == 45) return kCos45;
  const DoubleDouble t = radians(degrees);
  if (t.hi < kLinear) return {1, -0.5 * t.hi * t.hi};
  const DoubleDouble z = two_product(t.hi, t.hi);
  const DoubleDouble near = fast_two_sum(1, -0.5 * z.hi);
  const double far = z.hi * z.hi * polynomial(kCosine, z.hi) - t.hi * t.lo - 0.5 * z.lo;
  return fast_two_sum(near.hi, near.lo + far);
}

struct SineCosine {
  DoubleDouble sine, cosine;
};

DoubleDouble negated(const DoubleDouble& a) {
  return a.hi == 0 ? a : DoubleDouble{-a.hi, -a.lo};  // no negative zero
}

/// For any finite angle >= 0. Every subtraction is exact (fmod; then operands within a factor of
/// 2).
SineCosine sine_cosine(double degrees) {
  double rest = std::fmod(degrees, 360.0);
  const int quarter = (rest >= 90) + (rest >= 180) + (rest >= 270);
  rest -= 90 * quarter;
  SineCosine r = rest <= 45 ? SineCosine{sine_of_octant(rest), cosine_of_octant(rest)}
                            : SineCosine{cosine_of_octant(90 - rest), sine_of_octant(90 - rest)};
  switch (quarter) {
    case 1:
      return {r.cosine, negated(r.sine)};
    case 2:
      return {negated(r.sine), negated(r.cosine)};
    case 3:
      return {negated(r.cosine), r.sine};
    default:
      return r;
  }
}

DoubleDouble quotient(const DoubleDouble& a, const DoubleDouble& b) {
  const double q = a.hi / b.hi;
  if (q == 0 || !std::isfinite(q)) return {q, 0};
  const DoubleDouble back = two_product(q, b.hi);
  const double rest = (a.hi - back.hi) - back.lo + a.lo - q * b.lo;
  return fast_two_sum(q, rest / b.hi);
}

/// Arc tangent of y/x in degrees for 0 <= y <= x, 1 <= x < 2.
DoubleDouble arc_tangent_of_octant(double y, double x) {
  const double ratio = y / x;
  if (ratio < kLinear) {
    if (ratio < 0x1p-900) return {ratio * kDegrees.hi, 0};
    const DoubleDouble q = quotient({y, 0}, {x, 0});
    const DoubleDouble p = two_product(q.hi, kDegrees.hi);
    return fast_two_sum(p.hi, p.lo + q.hi * kDegrees.lo + q.lo * kDegrees.hi);
  }
  const double guess = ratio * polynomial(kArcTangent, ratio * ratio) * kDegrees.hi;
  const SineCosine at = sine_cosine(guess);
  // Turn (x, y) back by the guess: what remains is the tangent of its error, about 1e-5.
  const DoubleDouble up = two_product(y, at.cosine.hi), down = two_product(x, at.sine.hi);
  const double across = (up.hi - down.hi) + (up.lo - down.lo) + (y * at.cosine.lo - x * at.sine.lo);
  const double tangent = across / (x * at.cosine.hi + y * at.sine.hi);
  const double error = tangent - tangent * tangent * tangent / 3;
  return two_sum(guess, error * kDegrees.hi);
}

double rounded_sum(double a, const DoubleDouble& b) {
  const DoubleDouble s = two_sum(a, b.hi);
  return s.hi + (s.lo + b.lo);
}

}  // namespace

double sin_deg(double degrees) {
  if (!std::isfinite(degrees)) return std::numeric_limits<double>::quiet_NaN();
  return std::copysign(1.0, degrees) * sine_cosine(std::fabs(degrees)).sine.hi;
}

double cos_deg(double degrees) {
  if (!std::isfinite(degrees)) return std::numeric_limits<double>::quiet_NaN();
  return sine_cosine(std::fabs(degrees)).cosine.hi;
}

double tan_deg(double degrees) {
  if (!std::isfinite(degrees)) return std::numeric_limits<double>::quiet_NaN();
  const SineCosine r = sine_cosine(std::fabs(degrees));
  return std::copysign(1.0, degrees) * quotient(r.sine, r.cosine).hi;
}

double atan2_deg(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
  double across = std::fabs(y), along = std::fabs(x);
  if (std::isinf(across) || std::isinf(along)) {
    across = std::isinf(across) ? 1 : 0;
    along = std::isinf(along) ? 1 : 0;
  }
  const bool steep = across > along;
  if (steep) std::swap(across, along);
  DoubleDouble angle{0, 0};
  if (along > 0) {
    int exponent;
    const double unit = 2 * std::frexp(along, &exponent);
    angle = arc_tangent_of_octant(std::ldexp(across, 1 - exponent), unit);
  }
  const bool behind = std::signbit(x);
  const double base = steep ? 90 : (behind ? 180 : 0);
  if (steep != behind) angle = {-angle.hi, -angle.lo};
  return std::copysign(rounded_sum(base, angle), y);
}

double acos_deg(double c) {
  if (!(std::fabs(c) <= 1)) return std::numeric_limits<double>::quiet_NaN();
  return atan2_deg(std::sqrt((1 - c) * (1 + c)), c);
}

}  // namespace overstrike
