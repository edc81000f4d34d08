#pragma once
// Normals of a curved surface from the facets that stand for it.
#include <vector>

#include "core/geometry/winged_edges.h"

namespace overstrike {

/// Two facets of one curved surface meet at less than this angle: 30 degrees.
constexpr double kCreaseCosine = 0.8660254037844387;

/// Per edge whether its faces meet at less than 30 degrees.
std::vector<bool> shallow_edges(const Polyhedron& polyhedron, const std::vector<EdgePair>& edges);

/// One normal a corner: the mean of the normals of the faces round its vertex that `smooth` edges
/// join to its own, weighted by their angles there. A corner that is joined to none has its face's
/// normal, to the last bit.
std::vector<Vec3> smooth_normals(const Polyhedron& polyhedron, const std::vector<EdgePair>& edges,
                                 const std::vector<bool>& smooth);

}  // namespace overstrike
