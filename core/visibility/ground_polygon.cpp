#include "core/visibility/ground_polygon.h"

namespace overstrike {
namespace {

/// Keeps the part of a polygon of the grid where a x + b y + c >= 0.
std::vector<Vec2> cut(const std::vector<Vec2>& polygon, const Vec3& line) {
  std::vector<Vec2> result;
  const auto side = [&](const Vec2& p) { return line.x * p.x + line.y * p.y + line.z; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    const double fa = side(a), fb = side(b);
    if (fa >= 0) result.push_back(a);
    if ((fa < 0 && fb > 0) || (fa > 0 && fb < 0)) result.push_back(a + (b - a) * (fa / (fa - fb)));
  }
  return result;
}

}  // namespace

std::vector<Plane> ground_planes(const Canonical& c, const View& view) {
  std::vector<Plane> planes{{Vec3(0, 0, 1), c.ground_z.value_or(0)}, {Vec3(0), -1}};
  if (view.near_plane) planes.push_back(*view.near_plane);
  return planes;
}

std::vector<Vec2> ground_polygon(
    const Canonical& c, const View& view,
    const std::function<std::optional<DepthPlane>(GroundPlane)>& depth) {
  if (!c.ground_z || !(view.eye.z - *c.ground_z * view.eye.w > 0)) return {};
  const std::optional<DepthPlane> ground = depth(kGroundItself);
  if (!ground) return {};
  const double columns = view.grid.columns, rows = view.grid.rows;
  std::vector<Vec2> polygon{{-1, -1}, {columns + 1, -1}, {columns + 1, rows + 1}, {-1, rows + 1}};
  const auto keep_between = [&](const DepthPlane& near, const DepthPlane& far) {
    polygon = cut(polygon, Vec3(near.a - far.a, near.b - far.b, near.c - far.c));
  };
  if (view.perspective) keep_between(*ground, depth(kAtInfinity).value_or(DepthPlane{}));
  if (view.near_plane)
    if (const std::optional<DepthPlane> near = depth(kNearPlane)) keep_between(*near, *ground);
  return polygon;
}

}  // namespace overstrike
