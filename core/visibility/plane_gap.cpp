#include "core/visibility/plane_gap.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/error_free.h"
#include "core/geometry/expansion.h"
#include "core/visibility/depth.h"

namespace overstrike {
namespace {

constexpr double kEps = 0x1p-52;

/// What a gap without digits of its own is said to be: far below any that has.
constexpr double kSmallest = 0x1p-400;

Expansion exact_dot(const Vec3& a, const Vec3& b) {
  Expansion sum;
  for (int i = 0; i < 3; ++i) sum = sum + Expansion(a[i]) * Expansion(b[i]);
  return sum;
}

// In twice the digits: each of these loses at most 8 u^2 of the sizes of its arguments, u = 2^-53.
DoubleDouble sum(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = two_sum(a.hi, b.hi);
  return fast_two_sum(high.hi, high.lo + (a.lo + b.lo));
}
DoubleDouble product(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = two_product(a.hi, b.hi);
  return fast_two_sum(high.hi, high.lo + (a.hi * b.lo + a.lo * b.hi));
}
DoubleDouble dot(const Vec3& a, const Vec3& b) {
  return sum(sum(two_product(a.x, b.x), two_product(a.y, b.y)), two_product(a.z, b.z));
}

}  // namespace

double along(const Plane& plane, const Vec3& direction) {
  const double rough = glm::dot(plane.normal, direction);
  // The sizes of the products of two unit vectors add up to 1 at most, but for rounding.
  if (std::fabs(rough) > 2 * kDotError) return rough;
  return height_of_point(Plane{plane.normal, 0}, direction);
}

// h is off by kDotError times the sizes of its terms, at most `reach` and the offset, which |h|
// does not pass by more, and n . L by kDotError: so each product by kDotError size (|n . L| + 1).
// Doubled for rounding the products, their difference and the bound.
PlaneGap::PlaneGap(const Plane& upper, const Plane& lower, const Vec3& direction, double reach)
    : upper_(upper),
      lower_(lower),
      direction_(direction),
      along_upper_(along(upper, direction)),
      along_lower_(along(lower, direction)),
      same_side_((along_upper_ > 0) == (along_lower_ > 0)),
      reach_(reach) {
  const double upper_size = reach + std::fabs(upper.offset),
               lower_size = reach + std::fabs(lower.offset);
  size_ = upper_size + lower_size;
  error_ =
      2 * kDotError *
      (lower_size * (std::fabs(along_upper_) + 1) + upper_size * (std::fabs(along_lower_) + 1));
  if (!same_side_) along_upper_ = -along_upper_, along_lower_ = -along_lower_;
}

int PlaneGap::exact_sign(const Vec3& p) const {
  const auto height = [&](const Plane& plane) {
    return exact_dot(plane.normal, p) - Expansion(plane.offset);
  };
  const Expansion gap = height(lower_) * exact_dot(upper_.normal, direction_) -
                        height(upper_) * exact_dot(lower_.normal, direction_);
  return same_side_ ? gap.sign() : -gap.sign();
}

// Six sums, two products and their difference lose less than 2^7 u^2 = 2^-99 of the sizes; doubled
// for the bound.
double PlaneGap::precise(const Vec3& p) const {
  const auto height = [&](const Plane& plane) {
    return sum(dot(plane.normal, p), {-plane.offset, 0});
  };
  const DoubleDouble a = product(height(lower_), dot(upper_.normal, direction_)),
                     b = product(height(upper_), dot(lower_.normal, direction_)),
                     gap = sum(a, {-b.hi, -b.lo});
  if (std::fabs(gap.hi) <= 0x1p-98 * size_) {
    const int sign = exact_sign(p);
    return sign == 0 ? 0 : std::copysign(std::fmax(std::fabs(gap.hi), kSmallest), sign);
  }
  return same_side_ ? gap.hi : -gap.hi;
}

// The crossing is off by (error_a + error_b) / |gap_a - gap_b| of the way. Doubles may decide it
// while that moves it by no more than 2^10 times what coordinates are rounded by: by a billionth of
// a cell where the scene is 4096 cells across.
double PlaneGap::crossing(const Vec3& a, const Vec3& b, double gap_a, double gap_b) const {
  constexpr double kMostLost = 0x1p10 * kEps;
  const Vec3 way = glm::abs(b - a);
  const double length = std::max({way.x, way.y, way.z});
  if (2 * error_ * length > kMostLost * reach_ * std::fabs(gap_a - gap_b))
    gap_a = precise(a), gap_b = precise(b);
  return gap_a / (gap_a - gap_b);
}

}  // namespace overstrike
