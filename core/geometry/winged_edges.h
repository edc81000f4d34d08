#pragma once
// Which two faces meet at an edge.
#include <vector>

#include "core/geometry/polyhedron.h"

namespace overstrike {

constexpr Index kNoFace = 0xFFFFFFFFu;

/// `left` has (from, to) in one of its loops, `right` (to, from); `right` is kNoFace at a border.
struct EdgePair {
  Index from, to;
  Index left, right;
};

/// Every edge of every loop once, in order of its lower and its higher vertex. Edges of more than
/// two faces give several pairs, each of two faces that have solid between them (paired by angle
/// round the edge); what finds no partner of the other direction becomes a border.
std::vector<EdgePair> pair_edges(const Polyhedron& polyhedron);

}  // namespace overstrike
