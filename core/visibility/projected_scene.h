#pragma once
// A canonical input as one view shows it: grid points with error bounds, and which faces are seen.
#include <vector>

#include "core/visibility/canonical.h"
#include "core/visibility/depth.h"
#include "core/visibility/view.h"

namespace overstrike {

/// A point of space in the grid. The bounds hold for a point that was meant to be where it is:
/// placing and projecting have rounded it.
struct GridPoint {
  Vec3 at;             ///< x, y, depth
  double w;            ///< w^: 1 in a parallel view
  double error;        ///< of x and of y
  double depth_error;  ///< of the depth

  Vec2 xy() const { return Vec2(at); }
};

/// Placing a vertex costs at most 72 units of 2^-53 of the largest coordinate that takes part
/// (canonical.cpp has the count), projecting it four more a component, and the quotient one;
/// rounded up.
constexpr double kPointRounding = 80 * 0x1p-53;

GridPoint to_grid(const View& view, const Vec3& p);

/// Bound on the rounding of dot(plane.normal, p) - plane.offset for a placed vertex p.
double height_error(const Plane& plane, const Vec3& p);

class ProjectedScene {
 public:
  ProjectedScene(const Canonical& canonical_input, const View& in_view);

  /// The eye sees this side of the face: of closed bodies the outside, of open ones and of a
  /// solid's operands either.
  bool seen(Index face) const { return face != kNone && seen_[face] != 0; }
  /// 1 when the eye is on the face's outside, -1 behind it, 0 in its plane; exact.
  int side(Index face) const { return side_[face]; }
  /// The vertex belongs to a face of that plane: it lies on it by topology, whatever rounding says.
  bool touches(Index vertex, Index plane) const;
  /// Signed distance of a vertex from a plane (canonical.planes or ground()), 0 when it lies on it
  /// but for rounding.
  double height(Index plane, Index vertex) const;
  double height(Index plane, const Vec3& p) const;

  /// The ground's plane identity: one past the canonical input's.
  Index ground() const { return static_cast<Index>(canonical.planes.size()); }
  /// The near plane's, where there is one (view.near_plane): the ground ends there.
  Index near_plane() const { return ground() + 1; }
  /// The eye is above a ground, so that what lies below is hidden.
  bool has_ground() const { return has_ground_; }
  const Plane& plane(Index p) const { return planes_[p]; }
  const DepthPlane& depth(Index p) const { return depths_[p]; }
  bool has_depth(Index p) const { return depths_.has_depth(p); }

  const Canonical& canonical;
  const View& view;
  std::vector<GridPoint> points;  ///< of the vertices

 private:
  std::vector<Plane> planes_;
  DepthField depths_;
  std::vector<signed char> side_;
  std::vector<char> seen_;
  std::vector<Index> plane_start_, planes_of_vertex_;
  bool has_ground_ = false;
};

}  // namespace overstrike
