#pragma once
// The window that a scene fills.
#include <optional>

#include "core/visibility/camera_frame.h"

namespace overstrike {

/// A rectangle of the plane through the target across the line of sight, in (X', Y').
struct Window {
  Vec2 low{1e300}, high{-1e300};
  /// The largest coordinate, from the frame's origin, of what goes into the ground: what is seen of
  /// it may be as small as you like, and is no better known than its ends.
  double reach = 0;
  bool empty() const { return low.x > high.x; }
  void add(const Vec2& p) { low = glm::min(low, p), high = glm::max(high, p); }
  bool holds(const Vec2& p) const {
    return p.x >= low.x && p.y >= low.y && p.x <= high.x && p.y <= high.y;
  }
};

/// The smallest window that shows every body, pattern and segment; with a light at least 20 degrees
/// high and an eye above the ground also the bodies' shadows on the ground (lower light makes long
/// shadows that would leave no room for the bodies). What lies under the ground, seen from above
/// it, does not count unless everything does. Empty when the scene is. None when something stands
/// nearer than the near distance: such a scene cannot be fitted.
std::optional<Window> fitted_window(const Scene& scene, const CameraFrame& frame);

}  // namespace overstrike
