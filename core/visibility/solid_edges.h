#pragma once
// Where a line lies on the surfaces of solids, so that it is one of their edges.
#include <vector>

#include "core/visibility/solid_sight.h"

namespace overstrike {

struct SurfacePart {
  Interval over;
  StrokeKind kind;
  Index body;  ///< whose stroke it is
};

/// The parts along which the line is to be drawn where nothing hides it. `shown` is what solids
/// show on it, by SolidSight. A line in no solid's surface is one part, as it is; so is all of the
/// page.
///
/// A line in the surface of one solid is drawn where what is seen of the solid on its two sides is
/// not one plane, and is one that the line lies in on one of them at least: on one, it is a
/// contour; on both, the surface bends. Where an operand that is seen has an edge between the two
/// planes it is as that edge: nothing between facets of a round surface, else a crease, even if the
/// line comes from something else that runs there. It is a stroke of a body that is seen.
std::vector<SurfacePart> parts_on_surfaces(const Canonical& canonical, const SightLine& line,
                                           const std::vector<SolidSight::Part>& shown,
                                           double sliver);

}  // namespace overstrike
