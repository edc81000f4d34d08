#include "core/visibility/tie.h"

#include <algorithm>
#include <array>
#include <numeric>
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
  if (va != vb) return va < vb;
  const int pen_a = c.bodies[c.faces[f].body].pen, pen_b = c.bodies[c.faces[g].body].pen;
  return pen_a != pen_b ? pen_a < pen_b : f < g;
}

}  // namespace

bool wins_tie(const Canonical& c, Index f, Index g) {
  if (c.faces[f].cut != c.faces[g].cut) return c.faces[f].cut;
  const CanonicalBody &a = c.bodies[c.faces[f].body], &b = c.bodies[c.faces[g].body];
  if (a.density_factor != b.density_factor) return a.density_factor > b.density_factor;
  if (a.smooth != b.smooth) return b.smooth;
  return precedes(c, f, g);
}

Index FirstOfTied::of(std::span<const Index> faces) {
  // What is kept is a number for each face of the scene: not for a few.
  constexpr std::size_t kFew = 8;
  const bool keeps = faces.size() > kFew;
  if (keeps && lost_to_.empty()) {
    lost_to_.resize(canonical_.faces.size());
    std::iota(lost_to_.begin(), lost_to_.end(), Index{0});
    asked_.resize(canonical_.faces.size(), 0);
  }
  if (keeps) ++question_;
  for (std::size_t i = 0; keeps && i < faces.size(); ++i) asked_[faces[i]] = question_;
  Index first = kNone;
  for (const Index face : faces) {
    if (keeps && loses(face)) continue;
    const bool wins = first == kNone || wins_tie(canonical_, face, first);
    if (keeps && first != kNone) lost_to_[wins ? first : face] = wins ? face : first;
    if (wins) first = face;
  }
  return first;
}

/// It has lost to one that is there.
bool FirstOfTied::loses(Index face) {
  return lost_to_[face] != face && asked_[lost_to_[face]] == question_;
}

}  // namespace overstrike
