#pragma once
// What tessellate() chooses among; preconditions and laws are its own.
#include "core/geometry/polyhedron.h"
#include "core/scene/shapes.h"

namespace overstrike {

/// What an ellipsoid's exact counts come to; both 0 where the tolerance decides.
struct FacetCounts {
  int sides, rings;
};
FacetCounts facet_counts(const Ellipsoid&);

/// Facets round the axis times those along the profile, for a tolerance; `fine` when they keep it.
struct RoundCounts {
  int sides, rings;
  bool fine;
};
RoundCounts round_counts(const Frustum&, double chord);
RoundCounts round_counts(const Ellipsoid&, double chord);
RoundCounts round_counts(const Torus&, double chord);
RoundCounts round_counts(const Revolution&, double chord);

/// Clears the plane numbers where no two faces share one.
void drop_lone_planes(Polyhedron&);

Polyhedron faces_of(const Box&);
Polyhedron faces_of(const Wedge&);
Polyhedron faces_of(const Tetrahedron&);
Polyhedron faces_of(const FlatPolygon&);
Polyhedron faces_of(const Frustum&, double chord, bool normals);
Polyhedron faces_of(const Ellipsoid&, double chord, bool normals);
Polyhedron faces_of(const Torus&, double chord, bool normals);
Polyhedron faces_of(const Revolution&, double chord, bool normals);
Polyhedron faces_of(const Extrusion&);
Polyhedron faces_of(const Sweep&);

}  // namespace overstrike
