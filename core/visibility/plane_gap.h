#pragma once
// How far one stored plane lies over another along a direction: what decides whether a face casts
// shadow on a receiver, and where it stops to.
//
// Up to a positive factor the gap above p, from the lower plane to the upper, is
//   g(p) = s (h_lower(p) (n_upper . L) - h_upper(p) (n_lower . L)),  h(p) = n . p - offset,
// s the sign of (n_upper . L)(n_lower . L): linear, and the same all along the line p + t L. So it
// is asked of the world's vertices and no projection rounds it; how far they are off the planes
// that they are said to lie on does not count.
#include <cmath>

#include "core/visibility/canonical.h"

namespace overstrike {

/// dot(plane.normal, direction), of the right sign; unit vectors.
double along(const Plane& plane, const Vec3& direction);

class PlaneGap {
 public:
  /// Neither plane holds `direction`; the sizes of a point's coordinates add up to at most `reach`.
  PlaneGap(const Plane& upper, const Plane& lower, const Vec3& direction, double reach);

  /// g(p), of the right sign.
  double at(const Vec3& p) const {
    const double gap = rough(p);
    return std::fabs(gap) > error_ ? gap : precise(p);
  }
  /// Where g vanishes between a, where it is `gap_a`, and b, in parts of the way.
  double crossing(const Vec3& a, const Vec3& b, double gap_a, double gap_b) const;

 private:
  /// Off by at most error_.
  double rough(const Vec3& p) const {
    return (glm::dot(lower_.normal, p) - lower_.offset) * along_upper_ -
           (glm::dot(upper_.normal, p) - upper_.offset) * along_lower_;
  }
  /// Of the right sign, and off by at most 2^-98 of the sizes of its terms.
  double precise(const Vec3& p) const;
  int exact_sign(const Vec3& p) const;

  const Plane &upper_, &lower_;
  const Vec3& direction_;
  double along_upper_, along_lower_;  ///< times s
  bool same_side_;                    ///< s > 0
  double error_;
  double reach_, size_;  ///< of a point's coordinates, and of the terms of both heights
};

}  // namespace overstrike
