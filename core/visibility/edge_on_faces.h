#pragma once
// Faces whose planes pass through the eye, exactly: all of such a face is seen on one line.
//
// Its vertices are off that line by the rounding of their places, thousands of times as much close
// before the eye as elsewhere. Where that is more than lines are looked at beside themselves
// (run_source.h), a level along the line would meet some of the face's sides and miss others, and
// see into the body, or between two that stand on one another.
#include "core/visibility/front_table.h"

namespace overstrike {

/// Puts the vertices of the body's edge-on faces on their lines, upwards or downwards. Not where a
/// line is steeper than a diagonal: there a level meets it in no more than they are off.
void lay_edge_on_faces(FrontTable& table, Index body);

}  // namespace overstrike
