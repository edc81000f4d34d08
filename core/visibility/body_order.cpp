#include "core/visibility/body_order.h"

namespace overstrike {
namespace {

/// It may show a face in the plane that bounds it, from either side: as thin as a sheet (the
/// ground, which has no end, is not), or passing through itself.
bool may_show_border(const FrontBody& body, int axis) {
  const Vec3 size = body.high - body.low;
  const double most = std::fmax(std::fmax(size.x, size.y), size.z);
  return !body.simple || (std::isfinite(most) && size[axis] <= kThinBody * most);
}

/// Faces of the two may have been given one plane.
bool touch(const FrontBody& lower, const FrontBody& upper, int axis) {
  const double size = std::fmax(std::fabs(lower.high[axis]), std::fabs(upper.low[axis]));
  return upper.low[axis] - lower.high[axis] <= kThinBody * size;
}

/// Of a body below and one above a plane across the axis: 1 when the lower is in front. The plane
/// is put where the upper one begins.
int lower_first(const FrontBody& upper, int axis, const Vec4& eye) {
  if (eye.w == 0) return eye[axis] <= 0 ? 1 : -1;
  return eye[axis] <= upper.low[axis] ? 1 : -1;
}

}  // namespace

int order_of(const FrontBody& a, const FrontBody& b, const Vec4& eye) {
  // Bounds are of vertices; what is seen lies on planes. Depths are the planes'.
  const int axes = a.on_planes && b.on_planes ? 3 : 0;
  for (int axis = 0; axis < axes; ++axis) {
    const bool a_lower = a.high[axis] <= b.low[axis];
    if (!a_lower && !(b.high[axis] <= a.low[axis])) continue;
    const FrontBody &lower = a_lower ? a : b, &upper = a_lower ? b : a;
    if (touch(lower, upper, axis) && (may_show_border(a, axis) || may_show_border(b, axis)))
      continue;
    const int lower_in_front = lower_first(upper, axis, eye);
    return a_lower ? lower_in_front : -lower_in_front;
  }
  return (a.far_z > b.near_z) - (b.far_z > a.near_z);
}

}  // namespace overstrike
