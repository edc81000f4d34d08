#pragma once
// Phase I: what stands in whose light.
//
// Goals: each convex body's shadow on the ground and on every face behind it, once for all views of
// the eye; work by contours, not by faces times faces.
//
// Steps:
//  1. Contours of all bodies seen from the light (R = infinity).
//  2. Each contour's corners, dropped along the light by (3), are its ground shadow.
//  3. Pairs of contours whose boxes overlap: independent, crossing or enclosed (sign matrices), and
//     which is in front (9)(10).
//  4. The contour in front walks over the body behind: from its entry, or from the face that holds
//     its first corner, from face to face across the interior edges that it meets (11).
//  5. A face that it walked over keeps, as its shadow polygon, what lies inside the contour edges
//     that passed. Of the other faces those inside the contour are shadow all over.
//  6. Polygons are kept in face coordinates (12)(13), so that the eye pass only transforms them.
#include <array>
#include <vector>

#include "core/visibility/canonical.h"
#include "core/visibility/view.h"

namespace overstrike::nn74 {

/// A corner of a shadow polygon, P2 + (P1 - P2) t1 + (P3 - P2) t2. `own`: the side that leaves it
/// lies on the face's own outline.
struct ShadowCorner {
  double t1, t2;
  bool own;
};

/// A convex shadow on a face. Counter-clockwise seen from the light.
struct FaceShadow {
  Index face;                  ///< in the canonical input that receives
  std::array<Index, 3> frame;  ///< vertices P1, P2, P3
  std::vector<ShadowCorner> corners;
};

struct LightPhase {
  std::vector<FaceShadow> shadows;        ///< by face
  std::vector<char> covered;              ///< per face: in shadow all over
  std::vector<std::vector<Vec3>> ground;  ///< convex polygons on the ground
};

/// `whole` casts; `seen` (the same, or what near clipping left of it) receives, on the faces that
/// the light and the eye see from one side. Without light: nothing.
LightPhase cast(const Canonical& whole, const Canonical& seen, const View& eye);

}  // namespace overstrike::nn74
