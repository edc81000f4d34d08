#pragma once
// A view maps the world to a grid, by one 4 x 4 matrix: camera, window and grid at once.
#include <optional>

#include "core/picture.h"
#include "core/scene/scene.h"
#include "core/visibility/canonical.h"

namespace overstrike {

/// Positions are counted from `origin`, a point near the scene's middle, so that a scene far from
/// the world's zero keeps its last places: a view and a canonical input know no others.
///
/// (x^, y^, w^, z^) = matrix * (X, Y, Z, 1); grid x = x^/w^, y = y^/w^, depth z = z^/w^: larger is
/// nearer. w^ > 0 in front of the eye; in a parallel view w^ = 1. Depth is projective: planes stay
/// planes, so that depth is linear in x and y on every face (NN74 (1)(2) brought to homogeneous
/// form).
struct View {
  Vec3 origin{0.0};  ///< in the world
  Mat4 matrix{1.0};
  Grid grid;
  bool perspective = false;
  /// The eye, or the direction towards it when parallel (then w = 0).
  Vec4 eye{0, 0, 1, 0};
  /// What is not on the positive side, dot(normal, p) >= offset, is cut away. Always set in
  /// perspective.
  std::optional<Plane> near_plane;
  /// World length that makes about one grid unit at the depth of the target.
  double world_per_cell = 1;

  /// x, y, z (depth) of a point counted from the origin; precondition: w^ > 0.
  Vec3 project(const Vec3& p) const {
    const Vec4 h = matrix * Vec4(p, 1.0);
    return Vec3(h.x / h.z, h.y / h.z, h.w / h.z);
  }
};

/// The camera's view of the scene on the grid. The window is the one the camera gives, or fits the
/// scene, centred, with a margin of `margin` (a fraction of the grid's size) on every side. An eye
/// that has the scene around it cannot be fitted: 60 degrees then.
View make_view(const Scene& scene, const Grid& grid, double margin = 0.02);

/// The same view seen through another grid of coordinates: p' = scale * rotate(-angle) * (p -
/// origin) in the plane of the grid.
View turned(const View& view, double angle_deg, Vec2 origin, double scale);

}  // namespace overstrike
