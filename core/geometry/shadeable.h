#pragma once
// Faces over which corner normals can be interpolated.
#include "core/geometry/polyhedron.h"

namespace overstrike {

/// Tones are interpolated over the fan of triangles from a face's first corner: right where all
/// corner normals are equal, or the face is convex and has no holes. True when all faces are such.
bool is_shadeable(const Polyhedron& polyhedron);

/// Cuts the other faces into triangles over their own corners; those of one face share its plane
/// (plane_groups). A face that could not be cut without triangles of no area gets its plane's
/// normal at all corners instead. Precondition: there are corner normals.
Polyhedron shadeable(const Polyhedron& polyhedron);

}  // namespace overstrike
