#include "core/visibility/tie.h"

#include <algorithm>
#include <array>

namespace overstrike {
namespace {

using Key = std::array<double, 4>;

Key key(const Plane& p) { return {p.normal.x, p.normal.y, p.normal.z, p.offset}; }

std::vector<std::array<double, 3>> sorted_vertices(const Canonical& c, Index face) {
  std::vector<std::array<double, 3>> result;
  for (Index l = c.faces[face].first_loop; l < c.faces[face].end_loop; ++l)
    for (const Index v : c.loop(l))
      result.push_back({c.vertices[v].x, c.vertices[v].y, c.vertices[v].z});
  std::sort(result.begin(), result.end());
  return result;
}

/// The order of geometry.
bool precedes(const Canonical& c, Index f, Index g) {
  const Key a = key(c.planes[c.faces[f].plane]), b = key(c.planes[c.faces[g].plane]);
  if (a != b) return a < b;
  const auto va = sorted_vertices(c, f), vb = sorted_vertices(c, g);
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
