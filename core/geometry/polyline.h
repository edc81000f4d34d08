#pragma once
// Broken lines in the plane.
#include <vector>

#include "core/geometry/vec.h"

namespace overstrike {

/// The points without those that lie within `tolerance` of the line between the ones that are left
/// (D. H. Douglas, T. K. Peucker 1973); its ends stay. Precondition: there is a point.
std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance);

}  // namespace overstrike
