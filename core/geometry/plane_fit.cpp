#include "core/geometry/plane_fit.h"

#include <cmath>

#include "core/geometry/direction.h"

namespace overstrike {

PlaneFit PlaneFitter::fit() const {
  PlaneFit fit;
  if (points_ == 0) return fit;
  const double length = std::sqrt(glm::dot(vector_, vector_));
  fit.normal = unit(vector_);
  fit.middle = base_ + sum_ / points_;
  // From the base, so that a plane across an axis gets its vertices' own coordinate.
  fit.offset = glm::dot(fit.normal, base_) + glm::dot(fit.normal, sum_) / points_;
  fit.area = length / 2;
  fit.perimeter = perimeter_;
  return fit;
}

PlaneFit fit_plane(const Polyhedron& polyhedron, Index face) {
  PlaneFitter fitter;
  for (Index l = polyhedron.first_loop(face); l < polyhedron.face_ends[face]; ++l) {
    const std::span<const Index> loop = polyhedron.loop(l);
    fitter.add(loop.size(), [&](std::size_t i) { return polyhedron.vertices[loop[i]]; });
  }
  return fitter.fit();
}

}  // namespace overstrike
