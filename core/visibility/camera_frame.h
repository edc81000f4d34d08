#pragma once
// Where a camera stands and which way its axes point: what a view and a fitted window start from.
#include "core/geometry/tessellate.h"
#include "core/scene/scene.h"

namespace overstrike {

/// NN74 (1): X' to the right, Y' up, Z' from the target to the eye; unit vectors.
struct CameraFrame {
  Vec3 right, up, back;
  Vec3 target, eye;
  double distance;       ///< from target to eye, > 0
  double near_distance;  ///< along -Z' from the eye
  bool parallel;

  /// (X', Y', Z') of a world point; the target is the origin.
  Vec3 place(const Vec3& p) const {
    const Vec3 q = p - target;
    return {glm::dot(right, q), glm::dot(up, q), glm::dot(back, q)};
  }
  /// w of View: 1 at the target's depth and everywhere in a parallel view.
  double w(double depth) const { return parallel ? 1.0 : (distance - depth) / distance; }
};

/// Bodies, their patterns and the segments; empty when the scene has none.
Bounds scene_bounds(const Scene& scene);

/// The camera with every default filled in from the scene's bounds (a unit cube round the origin
/// when they are empty). An eye on its target looks along -Camera::from; an `up` along the line of
/// sight gives way to +Y, or to +Z when that is the line of sight.
CameraFrame camera_frame(const Camera& camera, const Bounds& bounds);

}  // namespace overstrike
