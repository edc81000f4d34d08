#pragma once
// Where a camera stands and which way its axes point: what a view and a fitted window start from.
#include "core/geometry/tessellate.h"
#include "core/scene/scene.h"

namespace overstrike {

/// NN74 (1): X' to the right, Y' up, Z' from the target to the eye; unit vectors.
struct CameraFrame {
  Vec3 origin;  ///< what positions are counted from, in the world
  Vec3 right, up, back;
  Vec3 target, eye;
  double distance;       ///< from target to eye, > 0
  double near_distance;  ///< along -Z' from the eye
  bool parallel;

  /// (X', Y', Z') of a point, from the target.
  Vec3 place(const Vec3& p) const {
    const Vec3 q = p - target;
    return {glm::dot(right, q), glm::dot(up, q), glm::dot(back, q)};
  }
  /// w of View: 1 at the target's depth and everywhere in a parallel view.
  double w(double depth) const { return parallel ? 1.0 : (distance - depth) / distance; }
};

/// Bodies, their patterns and the segments, from `origin`; empty when the scene has none.
Bounds scene_bounds(const Scene& scene, const Vec3& origin = Vec3(0.0));

/// Where positions are counted from, and the scene's bounds from there.
struct Stage {
  Vec3 origin;
  Bounds bounds;
};

/// The origin is what the camera looks at, or its eye, or the middle of the scene, to the nearest
/// 2^-20 of the scene's size. So coordinates of few digits are still exact when counted from there;
/// and a scene that is moved with its camera by a multiple of that, and whose coordinates stay
/// exactly representable, is the same to the last bit.
///
/// In perspective what lies d before the eye is off in the picture by its coordinates' rounding
/// over d, which is least at the near distance. There they are at most the distance from eye to
/// origin, but for their own d: where that is more than 2^10 near distances (a default near
/// distance is a thousandth of the way to the target) the origin is the eye; and it is rounded by
/// no more. So a place is off by at most 2^11 roundings of the picture's size: 4e-10 of a cell in
/// 1024.
Stage stage_of(const Scene& scene);

/// Counted from an origin.
inline Affine from_origin(const Affine& placement, const Vec3& origin) {
  return {placement.linear, placement.offset - origin};
}

/// The camera with every default filled in from the stage's bounds (a unit cube round the origin
/// when they are empty). An eye on its target looks along -Camera::from; an `up` along the line of
/// sight gives way to +Y, or to +Z when that is the line of sight.
CameraFrame camera_frame(const Camera& camera, const Stage& stage);

/// The unit vector to the scene's light; none when it has none.
std::optional<Vec3> light_of(const Scene& scene, const CameraFrame& frame);

}  // namespace overstrike
