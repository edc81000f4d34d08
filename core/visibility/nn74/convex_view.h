#pragma once
// Convex bodies as a view sees them, the light's or the eye's: NN74's projection, front faces,
// interior edges and contours.
//
// Notation: P_i are the corners of a contour in order; f(i, j) = turn_of(P_i, P_i+1, P_j) is
// positive inside. The paper's contours are clockwise with inside negative; here sides run
// counter-clockwise in the view's own coordinates (the grid's y points down, so that on the page
// they are clockwise), and inside is positive for all views.
#include <vector>

#include "core/visibility/canonical.h"
#include "core/visibility/light_frame.h"
#include "core/visibility/view.h"

namespace overstrike::nn74 {

/// A projected vertex; `near` grows towards the viewer and is linear over every plane: of two
/// points that project to one, that with the smaller ratio delta of (7) has the larger.
struct ViewedPoint {
  Vec2 at;
  double near;
  double at_error, near_error;  ///< bounds on the rounding of at.x, at.y and of near
};

/// A side of a front face.
struct Side {
  Index from, to;  ///< vertices
  Index face;      ///< in ConvexView::faces
  Index across;    ///< the front face on its other side: an interior edge; kNone: a contour edge
};

struct ViewedFace {
  Index face;  ///< in the canonical input
  Index first_side, end_side;
  Vec3 depth,
      depth_error;  ///< near = depth . (x, y, 1), off by at most depth_error . (|x|, |y|, 1)
};

/// A region of a view.
struct Extent {
  Vec2 low{1e300}, high{-1e300};
  void add(const Vec2& p) { low = glm::min(low, p), high = glm::max(high, p); }
};

/// One body; without contour it is seen edge-on, or not at all.
struct Contour {
  Index first_face = 0, end_face = 0;
  std::vector<Index> sides;  ///< contour edges, in order round it
  Extent box;
};

struct ConvexView {
  const Canonical& canonical;
  Vec4 viewer;  ///< the eye, or the direction to it or to the light with w = 0
  std::vector<ViewedPoint> points;
  std::vector<ViewedFace> faces;
  std::vector<Side> sides;
  std::vector<Contour> bodies;

  const Vec2& from(Index side) const { return points[sides[side].from].at; }
  const Vec2& to(Index side) const { return points[sides[side].to].at; }
};

/// R = infinity of (1)(2): across the light, near is the height towards it.
ConvexView view_from_light(const Canonical& canonical, const LightFrame& frame);
ConvexView view_from_eye(const Canonical& canonical, const View& view);

}  // namespace overstrike::nn74
