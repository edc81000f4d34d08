#pragma once
// Small vector helpers whose rounding is the same everywhere.
#include <cmath>

#include "core/geometry/vec.h"

namespace overstrike {

/// v divided by its length, one rounding a component after the root; the zero vector stays zero.
inline Vec3 unit(const Vec3& v) {
  const double length = std::sqrt(glm::dot(v, v));
  return length > 0 ? v / length : Vec3(0.0);
}

/// The largest magnitude of a component.
inline double max_norm(const Vec3& v) {
  return std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
}

}  // namespace overstrike
