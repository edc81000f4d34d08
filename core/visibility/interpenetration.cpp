#include "core/visibility/interpenetration.h"

#include <algorithm>
#include <numeric>

#include "core/geometry/tessellate.h"

namespace overstrike {
namespace {

Bounds bounds_of(const Canonical& c, const CanonicalBody& body) {
  Bounds box;
  for (Index v = body.first_vertex; v < body.end_vertex; ++v) box.add(c.vertices[v]);
  return box;
}

/// More than a touch on every axis; a flat body inside another's range overlaps it.
bool overlap(const Bounds& a, const Bounds& b) {
  for (int i = 0; i < 3; ++i)
    if (!(a.low[i] < b.high[i] && b.low[i] < a.high[i])) return false;
  return true;
}

/// True when the right face falls away behind the left one's plane at this edge.
bool convex_at(const Canonical& c, const WingedEdge& e) {
  const Vec3 normal = c.outward(c.faces[e.left]);
  const CanonicalFace& right = c.faces[e.right];
  const Vec3 origin = c.vertices[e.from];
  double highest = 0, size = 0;
  for (const Index v : c.loop(right.first_loop)) {
    const Vec3 d = c.vertices[v] - origin;
    highest = std::max(highest, glm::dot(normal, d));
    size = std::max(size, glm::dot(d, d));
  }
  // Only a hint what to look at twice: faces bent inwards by less than this part of their size
  // cannot pass through one another further than that.
  constexpr double kFlat = 0x1p-40;
  return highest * highest <= kFlat * kFlat * size;
}

/// A closed surface that is convex at every edge is convex, and so does not pass through itself.
bool is_convex(const Canonical& c, const CanonicalBody& body) {
  if (!body.closed) return body.end_face - body.first_face == 1;
  for (Index e = body.first_edge; e < body.end_edge; ++e) {
    const WingedEdge& edge = c.edges[e];
    if (edge.right == kNone || !convex_at(c, edge)) return false;
  }
  return true;
}

}  // namespace

std::vector<char> bodies_that_may_cross(const Canonical& c) {
  const std::size_t n = c.bodies.size();
  std::vector<char> may_cross(n, 0);
  std::vector<Bounds> boxes;
  boxes.reserve(n);
  for (const CanonicalBody& body : c.bodies) boxes.push_back(bounds_of(c, body));

  std::vector<Index> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return boxes[a].low.x < boxes[b].low.x; });
  std::vector<Index> open;
  for (const Index i : order) {
    std::erase_if(open, [&](Index j) { return boxes[j].high.x < boxes[i].low.x; });
    for (const Index j : open)
      if (overlap(boxes[i], boxes[j])) may_cross[i] = may_cross[j] = 1;
    open.push_back(i);
  }
  for (Index b = 0; b < n; ++b) {
    if (may_cross[b]) continue;
    const bool below_ground = c.ground_z && boxes[b].low.z < *c.ground_z;
    may_cross[b] = below_ground || !(c.bodies[b].simple || is_convex(c, c.bodies[b]));
  }
  return may_cross;
}

}  // namespace overstrike
