#pragma once
// A shape ready to be copied into its places: repaired faces, paired edges.
#include <string>

#include "core/geometry/winged_edges.h"
#include "core/scene/shapes.h"

namespace overstrike {

struct PreparedShape {
  Polyhedron polyhedron;
  std::vector<EdgePair> edges;
  std::vector<bool> smooth_edge;   ///< per edge: its faces stand for one curved surface
  bool closed = true;              ///< as CanonicalBody::closed
  double precision = 0;            ///< of the coordinates, as Mesh::precision
  std::vector<std::string> flaws;  ///< what was repaired, or could not be; in words
};

/// Tessellates to `chord` (units of the shape's frame) and repairs. With `smooth`, every shape has
/// corner normals: its own, or else means over edges that are shallower than 30 degrees. Faces
/// whose corner normals differ are then triangles or convex.
PreparedShape prepare_shape(const Shape& shape, double chord, bool smooth);

}  // namespace overstrike
