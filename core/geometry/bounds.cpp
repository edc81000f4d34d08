// Bounds: by the vertices of flat-faced shapes, by the furthest points of round ones.
#include <algorithm>
#include <cmath>

#include "core/geometry/tessellate.h"
#include "core/geometry/trig.h"

namespace overstrike {
namespace {

/// How far a circle about z of that radius, or its arc from +x over `angle_deg`, reaches along w.
double reach_of_arc(double radius, double angle_deg, const Vec3& w) {
  const double full = radius * std::sqrt(w.x * w.x + w.y * w.y);
  double furthest = atan2_deg(w.y, w.x);
  if (furthest < 0) furthest += 360;
  if (furthest <= angle_deg) return full;
  return radius * std::max(w.x, w.x * cos_deg(angle_deg) + w.y * sin_deg(angle_deg));
}

/// The largest w . p over the shape's points p.
double reach(const Frustum& s, const Vec3& w) {
  return std::max(reach_of_arc(s.bottom_radius, 360, w),
                  reach_of_arc(s.top_radius, 360, w) + s.height * w.z);
}

double reach(const Ellipsoid& s, const Vec3& w) { return glm::length(s.radii * w); }

double reach(const Torus& s, const Vec3& w) {
  return reach_of_arc(s.major, 360, w) + s.minor * glm::length(w);
}

double reach(const Revolution& s, const Vec3& w) {
  double furthest = -1e300;
  const auto add = [&](const std::vector<Vec2>& loop) {
    for (const Vec2& p : loop)
      furthest = std::max(furthest, reach_of_arc(p.x, s.angle_deg, w) + p.y * w.z);
  };
  add(s.profile);
  for (const std::vector<Vec2>& loop : s.more_loops) add(loop);
  return furthest;
}

template <class Round>
Bounds bounds_of_round(const Round& shape, const Affine& placement) {
  Bounds b;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 w{placement.linear[0][axis], placement.linear[1][axis], placement.linear[2][axis]};
    b.high[axis] = placement.offset[axis] + reach(shape, w);
    b.low[axis] = placement.offset[axis] - reach(shape, -w);
  }
  return b;
}

Bounds bounds_of(const std::vector<Vec3>& vertices, const Affine& placement) {
  Bounds b;
  for (const Vec3& vertex : vertices) b.add(placement(vertex));
  return b;
}

}  // namespace

Bounds bounds(const Shape& shape, const Affine& placement) {
  if (const Mesh* mesh = std::get_if<Mesh>(&shape))
    return bounds_of(mesh->polyhedron.vertices, placement);
  const bool curved = is_curved(shape);
  return std::visit(
      [&](const auto& s) {
        if constexpr (requires { reach(s, Vec3{}); })
          if (curved) return bounds_of_round(s, placement);
        return bounds_of(tessellate(shape, 0, false).vertices, placement);
      },
      shape);
}

Bounds BoundsOfCopies::operator()(const Shape& shape, const Affine& placement) {
  if (std::holds_alternative<Mesh>(shape) || is_curved(shape)) return bounds(shape, placement);
  const auto [found, is_new] = vertices_.try_emplace(&shape);
  if (is_new) found->second = tessellate(shape, 0, false).vertices;
  return bounds_of(found->second, placement);
}

}  // namespace overstrike
