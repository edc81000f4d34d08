#pragma once
// Visible straight pieces of the picture, on their way to strokes.
#include <vector>

#include "core/geometry/polyhedron.h"
#include "core/picture.h"

namespace overstrike {

struct LinePiece {
  Vec2 a, b;
  double error;  ///< how far rounding may have moved the line, in grid units
  StrokeKind kind;
  Index body;
  int pen;
  bool curved;
  Index rank;  ///< of the body, by what it is (strokes.cpp)
};

/// Draws no line twice: where pieces lie on one another, within their errors, one is kept. A
/// contour goes before the outline of a cut, a crease, an intersection, a shadow outline, a pattern
/// and a segment; among equal kinds the longer, then that of the body of lower rank, then the one
/// that lies before the other, then the smaller pen; never the order given.
std::vector<LinePiece> merged(std::vector<LinePiece> pieces, const Grid& grid);

/// Joins pieces of one body, kind and pen where just two of them end in one point. Of chains that
/// stand for curves points are left out while the rest stays within `tolerance`; of others only
/// such as lie on a straight line. Sorted by body, kind, pen and place; a chain runs from its
/// smaller end, a closed one from its smallest point to the smaller neighbour.
std::vector<Stroke> chained(const std::vector<LinePiece>& pieces, double tolerance);

}  // namespace overstrike
