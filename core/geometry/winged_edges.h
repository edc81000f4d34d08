#pragma once
// Which two faces meet at an edge.
#include <vector>

#include "core/geometry/polyhedron.h"

namespace overstrike {

constexpr Index kNoFace = 0xFFFFFFFFu;

/// `left` has (from, to) in one of its loops, `right` (to, from); `right` is kNoFace at a border.
/// The corners are the places in Polyhedron::indices where the two sides begin.
struct EdgePair {
  Index from, to;
  Index left, right;
  Index left_corner, right_corner;
};

/// The other side of an edge: where it begins and whose it is; kNoFace at a border.
struct Twin {
  Index corner, face;
};

/// Per corner the twin of the side that begins there.
std::vector<Twin> twins_of(const Polyhedron& polyhedron, const std::vector<EdgePair>& edges);

/// Every edge of every loop once, in order of its lower and its higher vertex. An edge of more than
/// two faces gives several pairs, each of one face of either direction, in the order of the faces;
/// what finds no partner becomes a border.
std::vector<EdgePair> pair_edges(const Polyhedron& polyhedron);

}  // namespace overstrike
