#include "core/shading/density_law.h"

#include <algorithm>

#include "core/visibility/depth.h"

namespace overstrike {
namespace {

double clamped(double density) { return std::clamp(density, 0.0, 1.0); }

}  // namespace

double lit_density(const Canonical& canonical, const CanonicalBody& body, const Vec3& normal) {
  const DensityLaw& law = canonical.law;
  const double cosine =
      canonical.light ? std::clamp(glm::dot(normal, *canonical.light), 0.0, 1.0) : 1.0;
  return clamped(law.hmax * (1 - law.k * cosine) * body.density_factor);
}

double shade_density(const Canonical& canonical, const CanonicalBody& body) {
  return clamped(canonical.law.hmax * body.density_factor);
}

FaceShade shade_of(const Canonical& canonical, const CanonicalFace& face, bool seen_from_behind) {
  const CanonicalBody& body = canonical.bodies[face.body];
  if (face.cut) {
    const DensityLaw& law = canonical.law;
    return {clamped(law.cut_factor * law.hmax * body.density_factor), false};
  }
  if (!canonical.light) return {lit_density(canonical, body, Vec3(0.0)), true};
  const Vec3 outward = canonical.outward(face);
  const Vec3 normal = seen_from_behind ? -outward : outward;
  // NN74's tie rule: light along the face is shade. Exact, as who receives shadows is.
  const bool lit = side_of_direction(canonical.planes[face.plane], face.flipped,
                                     *canonical.light) == (seen_from_behind ? -1 : 1);
  return {lit ? lit_density(canonical, body, normal) : shade_density(canonical, body), lit};
}

}  // namespace overstrike
