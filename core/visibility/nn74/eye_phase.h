#pragma once
// Phase II: what the eye sees, laid out for painting along scan lines.
//
// Steps:
//  1. Contours and front faces as the eye sees them (4)(6); each side of a face and of a contour
//     becomes a border, on the left or on the right of what it bounds.
//  2. Shadow polygons are brought from face coordinates (12) to the picture, ground shadows too,
//     cut at the near plane.
//  3. Pairs of contours that overlap, and which is in front (7)(8).
#include <vector>

#include "core/visibility/canonical.h"
#include "core/visibility/nn74/light_phase.h"
#include "core/visibility/view.h"

namespace overstrike::nn74 {

/// A straight border as scan lines meet it: downwards, active on y0 <= y < y1.
struct Border {
  double x0, y0, x1, y1;
  double slope;  ///< dx/dy
  Index face;    ///< of a contour: the front face along it; of a face: the front face across it, or
                 ///< kNone
  bool own;      ///< of a shadow: it lies on the face's own outline

  /// The paper adds dx/dy from line to line; here x comes from the border's end, so that jumping to
  /// a line equals stepping to it, and is exact at both ends.
  double x_at(double y) const { return y == y1 ? x1 : x0 + (y - y0) * slope; }
};

/// The left and the right chain of a convex outline, each from top to bottom.
struct Outline {
  std::vector<Border> left, right;
  double top = 1e300, bottom = -1e300;

  /// Adds the side from a to b of an outline that has its inside where turn(a, b, p) > 0: as y
  /// points down, sides going down bound it on the right.
  void add(const Vec2& a, const Vec2& b, Index face, bool own);
  void sort();
};

/// The border of a chain that is active at y, or nullptr.
const Border* active(const std::vector<Border>& chain, double y);

struct PictureFace {
  Index face, plane, body;
  Kind kind;
  double density, in_shadow;
  bool covered;
  Outline outline;
  std::vector<Outline> shadows;
};

struct PictureBody {
  Index number;  ///< in the canonical input
  Outline outline;
};

struct Picture {
  double columns, rows;
  const Canonical& canonical;
  std::vector<PictureFace> faces;
  std::vector<PictureBody> bodies;
  std::vector<Outline> ground_shadows;
  double ground_density;
  /// Per body, by the other's number: 1 when this one is in front, -1 when it is behind.
  struct Order {
    Index other;
    int front;
  };
  std::vector<std::vector<Order>> orders;

  /// 1 when body a is in front of body b, -1 when it is behind, 0 when neither hides the other.
  int front(Index a, Index b) const;
  /// True when f hides g though both lie in one plane (the house's rule, tie.h; the paper has no
  /// coplanar faces).
  bool wins_tie(Index f, Index g) const;
};

Picture look(const Canonical& seen, const View& view, const LightPhase& light);

}  // namespace overstrike::nn74
