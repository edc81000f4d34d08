#pragma once
// Bounds along the world's axes, of things and of where they matter.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/vec.h"

namespace overstrike {

struct WorldBox {
  Vec3 low{std::numeric_limits<double>::infinity()};
  Vec3 high{-std::numeric_limits<double>::infinity()};

  static WorldBox everything() {
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    return {Vec3(-kEndless), Vec3(kEndless)};
  }
  void add(const Vec3& p) { low = glm::min(low, p), high = glm::max(high, p); }
  void add(const WorldBox& other) {
    low = glm::min(low, other.low), high = glm::max(high, other.high);
  }
  void keep(const WorldBox& other) {
    low = glm::max(low, other.low), high = glm::min(high, other.high);
  }
  /// Sets within bounds that touch may have faces in one plane, and vertices are rounded: a gap is
  /// wider than this part of where it is, far more than what welding calls one plane.
  static constexpr double kLeastGap = 0x1p-20;
  /// No point, and none nearly.
  bool empty() const {
    for (int i = 0; i < 3; ++i) {
      const double size = std::max(std::fabs(low[i]), std::fabs(high[i]));
      if (low[i] > high[i] && (!std::isfinite(size) || low[i] - high[i] > kLeastGap * size))
        return true;
    }
    return false;
  }
};

inline WorldBox common(WorldBox a, const WorldBox& b) {
  a.keep(b);
  return a;
}

}  // namespace overstrike
