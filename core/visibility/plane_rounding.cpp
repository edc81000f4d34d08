#include "core/visibility/plane_rounding.h"

#include <algorithm>
#include <cmath>

namespace overstrike {
namespace {

bool is_on_plane(const Canonical& c, const CanonicalFace& face) {
  const Plane& plane = c.planes[face.plane];
  const Index end = c.loop_ends[face.end_loop - 1];
  for (Index i = c.first_corner(face.first_loop); i < end; ++i) {
    const Vec3& p = c.vertices[c.corners[i]];
    const double size = std::fabs(plane.offset) + std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z);
    if (std::fabs(glm::dot(plane.normal, p) - plane.offset) > kPlaneRounding * size) return false;
  }
  return true;
}

}  // namespace

void note_bodies_on_planes(Canonical& canonical) {
  for (CanonicalBody& body : canonical.bodies)
    body.on_planes = std::all_of(canonical.faces.begin() + body.first_face,
                                 canonical.faces.begin() + body.end_face,
                                 [&](const CanonicalFace& f) { return is_on_plane(canonical, f); });
}

}  // namespace overstrike
