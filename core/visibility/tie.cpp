#include "core/visibility/tie.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace overstrike {
namespace {

using Key = std::array<double, 4>;

Key key(const Plane& p) { return {p.normal.x, p.normal.y, p.normal.z, p.offset}; }

std::span<const Index> corners_of(const Canonical& c, const CanonicalFace& face) {
  const Index first = c.first_corner(face.first_loop), end = c.loop_ends[face.end_loop - 1];
  return {c.corners.data() + first, c.corners.data() + end};
}

using Point = std::array<double, 3>;

Point point(const Canonical& c, Index vertex) {
  const Vec3& p = c.vertices[vertex];
  return {p.x, p.y, p.z};
}

Point least_vertex(const Canonical& c, const CanonicalFace& face) {
  const std::span<const Index> corners = corners_of(c, face);
  Point least = point(c, corners[0]);
  for (const Index v : corners.subspan(1)) least = std::min(least, point(c, v));
  return least;
}

std::vector<Point> sorted_vertices(const Canonical& c, const CanonicalFace& face) {
  std::vector<Point> result;
  for (const Index v : corners_of(c, face)) result.push_back(point(c, v));
  std::sort(result.begin(), result.end());
  return result;
}

/// The order of geometry.
bool precedes(const Canonical& c, Index f, Index g) {
  const Key a = key(c.planes[c.faces[f].plane]), b = key(c.planes[c.faces[g].plane]);
  if (a != b) return a < b;
  const Point least_a = least_vertex(c, c.faces[f]), least_b = least_vertex(c, c.faces[g]);
  if (least_a != least_b) return least_a < least_b;
  const auto va = sorted_vertices(c, c.faces[f]), vb = sorted_vertices(c, c.faces[g]);
  return va != vb ? va < vb : f < g;
}

}  // namespace

bool wins_tie(const Canonical& c, Index f, Index g) {
  if (c.faces[f].cut != c.faces[g].cut) return c.faces[f].cut;
  const CanonicalBody &a = c.bodies[c.faces[f].body], &b = c.bodies[c.faces[g].body];
  if (a.density_factor != b.density_factor) return a.density_factor > b.density_factor;
  if (a.smooth != b.smooth) return b.smooth;
  return precedes(c, f, g);
}

}  // namespace overstrike
