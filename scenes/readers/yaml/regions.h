#pragma once
// Plane regions of a scene file: outlines, rectangles, circles, and set operations on them.
#include "core/scene/shapes.h"
#include "scenes/readers/yaml/tree.h"

namespace overstrike::yaml {

/// The region that the value says, resolved (core/geometry/region_sets.h). Empty after an error;
/// that nothing is left of it is one.
Region read_region(Reporter&, const Node&);

}  // namespace overstrike::yaml
