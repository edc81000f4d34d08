#pragma once
// What a node's shape is made of.
#include <vector>

#include "core/scene/shapes.h"
#include "scenes/readers/openscad/arguments.h"

namespace overstrike::openscad {

/// A closed shape in a node's frame. Several are their union.
struct Part {
  ShapePtr shape;
  Affine place;
  double precision = 0;  ///< how far its vertices may be from what was meant, in the node's frame
};

/// The corners of a part, in the node's frame.
std::vector<Vec3> corners_of(const Part& part);

/// As Part::precision, in the frame that the node is placed in.
double placed_precision(const Part& part, const Placement& place);

/// A flat region in z = 0.
struct Flat {
  Region region;
  double precision = 0;
};

}  // namespace overstrike::openscad
