#pragma once
// The caps that close a cut polyhedron.
#include "core/geometry/cut_polyhedron.h"

namespace overstrike {

/// Closes the open edges between vertices of the cut with one face for each layer of their winding
/// numbers (winding_layers.h): kCap where they go round counter-clockwise, seen against `normal`,
/// kTurnedCap where they go round clockwise. Where outlines cross or lie on one another, the faces'
/// loops get the points that their edges are divided at, and vertices in one place become one, so
/// that every edge still has two sides.
void add_caps(CutPolyhedron& cut, const std::vector<bool>& in_plane, const Vec3& normal);

}  // namespace overstrike
