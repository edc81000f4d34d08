#pragma once
// Loose lines -> loops.
#include <vector>

#include "core/geometry/polygon.h"

namespace overstrike::openscad {

struct Line {
  Vec2 from, to;
};

/// Ends within a thousandth (2^-10, OpenSCAD's coarse grid) of one another are one. Paths that have
/// ends are closed by a straight line.
std::vector<Loop2> join_lines(const std::vector<Line>& lines);

}  // namespace overstrike::openscad
