#pragma once
// Bounds of the depths of some faces.
#include <algorithm>
#include <cmath>
#include <span>

#include "core/visibility/depth.h"

namespace overstrike {

class DepthRange {
 public:
  /// The faces' points have coordinates of at most `reach`.
  DepthRange(const DepthMap& map, const Vec2& reach)
      : map_(map),
        sizes_(reach.x * map.normal_size_[0] + reach.y * map.normal_size_[1] + map.normal_size_[2]),
        sizes_by_offset_(reach.x * std::fabs(map.rounded_[3][0]) +
                         reach.y * std::fabs(map.rounded_[3][1]) + std::fabs(map.rounded_[3][2])) {}

  /// Widens the bounds by a plane's depth over some points, where it is extreme at one of them.
  /// False when it passes through the eye.
  bool add(Index plane, std::span<const Index> corners, const Vec2* points);

  double low = HUGE_VAL, high = -HUGE_VAL;

 private:
  const DepthMap& map_;
  double sizes_, sizes_by_offset_;  ///< of all terms but those of pi'_z
};

// |z - exact z| <= 2 (|x| e_x + |y| e_y + e_w + |z| e_z) / |pi'_z| while pi'_z keeps its first
// digits: e_j bound the errors of the components of pi', here for all normals of unit length, and
// the factor covers the rounding of this and of z itself, which is at most as large.
inline bool DepthRange::add(Index number, std::span<const Index> corners, const Vec2* points) {
  const Plane& p = map_.plane(number);
  const double z = map_.component(p, 3), size_z = map_.size(p, 3);
  constexpr double kFirstDigits = 1e-3;
  if (!(kDotError * size_z <= kFirstDigits * std::fabs(z))) {
    low = -HUGE_VAL, high = HUGE_VAL;
    return map_.depth(number).has_value();
  }
  const double over = -1 / z;
  const double a = map_.component(p, 0) * over, b = map_.component(p, 1) * over;
  const double c = map_.component(p, 2) * over;
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const Index corner : corners) {
    const double depth = a * points[corner].x + b * points[corner].y + c;
    least = std::min(least, depth), most = std::max(most, depth);
  }
  const double farthest = std::max(std::fabs(least), std::fabs(most));
  const double sizes = sizes_ + std::fabs(p.offset) * sizes_by_offset_ + farthest * size_z;
  const double error = 4 * kDotError * sizes * std::fabs(over);
  low = std::min(low, least - error), high = std::max(high, most + error);
  return true;
}

}  // namespace overstrike
