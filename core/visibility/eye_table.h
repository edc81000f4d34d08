#pragma once
// Phase II: what the eye can see of a canonical input, laid out for scanning.
#include <array>
#include <vector>

#include "core/visibility/canonical.h"
#include "core/visibility/depth.h"
#include "core/visibility/shadows.h"
#include "core/visibility/view.h"

namespace overstrike {

/// A region of one plane that the eye may see: a face, a triangle of a smooth face, or the ground.
struct EyeFace {
  Index plane;
  Index surface;  ///< the face's number in the canonical input; one past the last for the ground
  Index body;
  Kind kind;       ///< away from shadows
  bool may_cross;  ///< its body may pass through another, or through itself
  bool smooth;
  double density;  ///< away from shadows; of a smooth face: the mean of its corners
  double in_shadow;
  /// Smooth: density = (q . (x, y, 1)) / (w . (x, y, 1)).
  Vec3 q{0.0}, w{0.0};
  double least = 0, most = 1;  ///< of its corners: a triangle seen nearly edge-on has few digits

  double density_at(double x, double y) const {
    if (!smooth) return density;
    const double d = (q.x * x + q.y * y + q.z) / (w.x * x + w.y * y + w.z);
    return d >= least ? (d <= most ? d : most) : least;
  }
};

/// An edge as scan lines meet it: downwards, active on y0 <= y < y1. Passing it from left to right
/// turns `faces` on or off; a shadow edge (winding != 0) instead changes the count of its receiver,
/// shadow_slot.
struct ScanEdge {
  double x0, y0, x1, y1;
  double slope;                ///< dx/dy
  double x_error;              ///< bound on the error of x_at, from the projection's rounding
  std::array<Index, 2> faces;  ///< in EyeTable::faces; kNone where there is none
  Index shadow_slot;
  int winding;

  /// Evaluated from the end, never accumulated: jumping to a line equals stepping to it. Exact at
  /// both ends.
  double x_at(double y) const { return y == y1 ? x1 : x0 + (y - y0) * slope; }
};

/// A horizontal edge turns nothing on, but ties what lies at its ends together.
struct FlatEdge {
  double x0, x1, y;
};

struct EyeTable {
  EyeTable(const Canonical& canonical, const View& view, const std::vector<Shadow>& shadows);

  std::size_t face_count() const { return faces.size(); }
  Index plane_of(Index face) const { return faces[face].plane; }
  bool crosses(Index face) const { return faces[face].may_cross; }
  /// True when f hides g at a point of equal depth (tie.h).
  bool wins_tie(Index f, Index g) const;
  /// Sign of depth(f) - depth(g), exact; the ground lies behind every body that does not reach
  /// below it.
  int compare(Index f, Index g, double x, double y) const {
    if (f == ground && !faces[g].may_cross) return -1;
    if (g == ground && !faces[f].may_cross) return 1;
    return depths.compare(faces[f].plane, faces[g].plane, x, y);
  }
  /// f before g at the point, ties decided.
  bool in_front(Index f, Index g, double x, double y) const {
    const int side = compare(f, g, x, y);
    return side != 0 ? side > 0 : wins_tie(f, g);
  }
  Kind kind(Index face, bool shadowed) const {
    if (!shadowed) return faces[face].kind;
    return face == ground ? Kind::ground_shadow : Kind::shadow;
  }

  const Canonical& canonical;
  double columns, rows;
  std::vector<Plane> planes;  ///< the canonical's and those that bound the ground
  DepthField depths;
  std::vector<EyeFace> faces;
  std::vector<Index> shadow_slot;  ///< per surface: its count's place, or kNone
  std::vector<char> covered;       ///< per shadow slot: in shadow all over
  std::vector<ScanEdge> edges;
  std::vector<FlatEdge> flat_edges;
  Index ground = kNone;
};

}  // namespace overstrike
