#pragma once
// Lines of bodies that reach far out of the picture, as what stands close before the eye does when
// it is cut at the near plane: a plain may end ten million million cells away.
//
// Evaluated from such an end a line is off by the rounding of that end's coordinates, whole cells
// in the end; and where a face is cut at the near plane, both ends are off by the rounding of the
// body's size over the near distance. So of a far body's lines only what the levels of the picture
// meet is kept, and its ends are found exactly: from the vertices, or, where a face is cut, from
// the two planes, which are what the picture is defined by.
#include <algorithm>
#include <cmath>

#include "core/visibility/front_table.h"

namespace overstrike {

/// Cells from the grid's zero. Up to there a line is evaluated from its ends in doubles: its place
/// is rounded by 4 * 2^-52 of that at most, which is 2^-30, a billionth of a cell, and nothing
/// tells less (FaceOrder::crossing).
constexpr double kFarAway = 0x1p20;

/// Beyond kFarAway, or nowhere.
inline bool is_far_away(const Vec2& p) {
  return !(std::max(std::fabs(p.x), std::fabs(p.y)) <= kFarAway);
}

/// The part that the levels of the picture meet of the line between two points, which is `rough`
/// but for rounding; y0 >= y1 when there is none.
LevelLine far_line(const View& view, const Vec3& top, const Vec3& bottom, const LevelLine& rough);

/// FrontTable::line of a far body; y0 >= y1 when no level of the picture meets it.
LevelLine far_line(const FrontTable& table, const std::array<Index, 2>& ends,
                   const std::array<Index, 2>& faces);

/// Bounds the errors of a far body's lines where they are in the picture.
LineError far_line_error(const FrontTable& table, Index body);

}  // namespace overstrike
