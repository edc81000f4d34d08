#include "core/visibility/shared_edge.h"

#include <algorithm>
#include <span>
#include <utility>

namespace overstrike {
namespace {

/// The edges of one body between two vertices.
std::span<const WingedEdge> edges_between(const Canonical& c, const CanonicalBody& body, Index v,
                                          Index w) {
  struct InOrder {
    static std::pair<Index, Index> key(const WingedEdge& e) { return std::minmax(e.from, e.to); }
    bool operator()(const WingedEdge& e, std::pair<Index, Index> ends) const {
      return key(e) < ends;
    }
    bool operator()(std::pair<Index, Index> ends, const WingedEdge& e) const {
      return ends < key(e);
    }
  };
  const auto [first, end] =
      std::equal_range(c.edges.begin() + body.first_edge, c.edges.begin() + body.end_edge,
                       std::pair<Index, Index>(std::minmax(v, w)), InOrder());
  return {first, end};
}

/// The edge in which a face meets one in another plane, of the same body.
const WingedEdge* edge_to(const Canonical& c, Index face, Index plane) {
  const CanonicalBody& body = c.bodies[c.faces[face].body];
  for (Index l = c.faces[face].first_loop; l < c.faces[face].end_loop; ++l) {
    const std::span<const Index> loop = c.loop(l);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index other = c.twin(body, c.first_corner(l) + static_cast<Index>(i)).face;
      if (other == kNone || c.faces[other].plane != plane) continue;
      const Index next = loop[i + 1 == loop.size() ? 0 : i + 1];
      for (const WingedEdge& e : edges_between(c, body, loop[i], next))
        if (std::minmax(e.left, e.right) == std::minmax(face, other)) return &e;
    }
  }
  return nullptr;
}

}  // namespace

const WingedEdge* shared_edge(const Canonical& c, Index f, Index g) {
  const auto corners = [&](Index face) {
    return c.loop_ends[c.faces[face].end_loop - 1] - c.first_corner(c.faces[face].first_loop);
  };
  if (corners(f) > corners(g)) std::swap(f, g);
  const WingedEdge* const edge = edge_to(c, f, c.faces[g].plane);
  if (c.faces[f].body == c.faces[g].body || (edge != nullptr && !edge->crease)) return edge;
  const WingedEdge* const other = edge_to(c, g, c.faces[f].plane);
  return other != nullptr && (edge == nullptr || !other->crease) ? other : edge;
}

}  // namespace overstrike
