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

/// Every edge of every loop once, in order of its lower and its higher vertex. An edge of more than
/// two faces gives several pairs, each of one face of either direction, in the order of the faces;
/// what finds no partner becomes a border.
std::vector<EdgePair> pair_edges(const Polyhedron& polyhedron);

}  // namespace overstrike
