#include "core/visibility/body_order.h"

namespace overstrike {
namespace {

bool is_thin(const FrontBody& body, int axis) {
  const Vec3 size = body.high - body.low;
  const double most = std::fmax(std::fmax(size.x, size.y), size.z);
  return size[axis] <= kThinBody * most;
}

/// Of a body below and one above a plane across the axis: 1 when the lower is in front. The plane
/// may be put anywhere between them.
int lower_first(const FrontBody& lower, const FrontBody& upper, int axis, const Vec4& eye) {
  if (eye.w == 0) return eye[axis] <= 0 ? 1 : -1;
  if (eye[axis] <= upper.low[axis]) return 1;
  return eye[axis] >= lower.high[axis] ? -1 : 0;
}

}  // namespace

int order_of(const FrontBody& a, const FrontBody& b, const Vec4& eye) {
  const bool may_tie = a.shares_plane && b.shares_plane;
  for (int axis = 0; axis < 3; ++axis) {
    const bool a_lower = a.high[axis] <= b.low[axis];
    if (!a_lower && !(b.high[axis] <= a.low[axis])) continue;
    if (may_tie && (is_thin(a, axis) || is_thin(b, axis))) continue;
    return a_lower ? lower_first(a, b, axis, eye) : -lower_first(b, a, axis, eye);
  }
  return (a.far_z > b.near_z) - (b.far_z > a.near_z);
}

}  // namespace overstrike
