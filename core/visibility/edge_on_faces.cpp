#include "core/visibility/edge_on_faces.h"

#include <cmath>

namespace overstrike {

// A plane (x, y, w, z) of the grid that passes through the eye has no z: a x + b y + c = 0.
void lay_edge_on_faces(FrontTable& table, Index body) {
  const Canonical& c = table.canonical;
  for (Index i = c.bodies[body].first_face; i < c.bodies[body].end_face; ++i) {
    const CanonicalFace& f = c.faces[i];
    if (side_of_eye(c.planes[f.plane], f.flipped, table.view.eye) != 0) continue;
    const ExactPlane plane = table.depths.exact(f.plane);
    const double a = plane[0].approximate(), b = plane[1].approximate();
    if (b == 0 || std::fabs(b) < std::fabs(a)) continue;
    for (Index k = c.first_corner(f.first_loop); k < c.loop_ends[f.end_loop - 1]; ++k) {
      Vec2& at = table.points[c.corners[k]];
      at.y = -(a * at.x + plane[2].approximate()) / b;
    }
  }
}

}  // namespace overstrike
