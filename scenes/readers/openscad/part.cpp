#include "scenes/readers/openscad/part.h"

#include <algorithm>

#include "core/geometry/tessellate.h"

namespace overstrike::openscad {

std::vector<Vec3> corners_of(const Part& part) {
  std::vector<Vec3> corners = tessellate(*part.shape, 1, false).vertices;
  for (Vec3& p : corners) p = part.place(p);
  return corners;
}

double placed_precision(const Part& part, const Placement& place) {
  const Bounds box = bounds(*part.shape, part.place);
  const Vec3 reach = glm::max(glm::abs(box.low), glm::abs(box.high));
  const Mat3& a = place.affine.linear;
  const Vec3 own = Mat3(glm::abs(a[0]), glm::abs(a[1]), glm::abs(a[2])) * Vec3(part.precision);
  const Vec3 all = own + place.error.linear * reach + place.error.offset;
  return std::max({all.x, all.y, all.z});
}

}  // namespace overstrike::openscad
