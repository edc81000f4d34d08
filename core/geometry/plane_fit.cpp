#include "core/geometry/plane_fit.h"

#include <cmath>

#include "core/geometry/direction.h"
#include "core/geometry/error_free.h"

namespace overstrike {

namespace {

/// A sum below this part of its widest triangle is what rounding left of it when the vertices are
/// up to 2^20 times as far away as the face is large (2^-53 * 2^20, and 2^3 for the sum's terms).
constexpr double kCancelled = 0x1p-30;

double difference_of_products(double a, double b, double c, double d) {
  const DoubleDouble p = two_product(a, b), q = two_product(c, d);
  return (p.hi - q.hi) + (p.lo - q.lo);
}

}  // namespace

Vec3 compensated_cross(const Vec3& a, const Vec3& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

PlaneFit PlaneFitter::fit() const {
  PlaneFit fit;
  if (points_ == 0) return fit;
  const double sum = std::sqrt(glm::dot(vector_, vector_));
  const double widest = std::sqrt(glm::dot(widest_, widest_));
  fit.cancels = sum < widest * kCancelled;
  const double length = fit.cancels ? widest : sum;
  fit.normal = unit(fit.cancels ? widest_ : vector_);
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
