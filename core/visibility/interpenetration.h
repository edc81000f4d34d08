#pragma once
// Which bodies may pass through each other: only those pay for crossings.
#include <vector>

#include "core/visibility/canonical.h"

namespace overstrike {

/// Per body: 1 when its bounding box overlaps another body's by more than a touch, when it reaches
/// below the ground, or when it may pass through itself (a body that is not convex and not known to
/// be simple). Sweep over x, so that scattered bodies cost n log n.
std::vector<char> bodies_that_may_cross(const Canonical& canonical);

}  // namespace overstrike
