#pragma once
// Flat regions as extrusions need them.
#include "core/geometry/polygon.h"
#include "scenes/readers/openscad/part.h"

namespace overstrike::openscad {

/// Placed in the plane: what the placement does to x and y.
Region placed(const Region& region, const Affine& placement);

/// Outlines counter-clockwise, holes clockwise, holes with their outlines. Loops may touch in
/// single points.
OrderedRegion pieces_of(const Region& region);

/// One face for each piece, over loops of vertices that begin with `first_vertex` and follow one
/// another as the region's loops do; `turned` for a face that looks down.
void add_faces(Polyhedron& p, const OrderedRegion& region, Index first_vertex, bool turned);

}  // namespace overstrike::openscad
