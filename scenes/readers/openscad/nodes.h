#pragma once
// What each node of the tree is to the others: which are drawn, of what dimension, where they
// stand, and in what colour.
#include <optional>
#include <vector>

#include "scenes/readers/openscad/arguments.h"
#include "scenes/readers/openscad/tree.h"
#include "scenes/readers/openscad/words.h"

namespace overstrike::openscad {

constexpr Index kNoNode = 0xFFFFFFFFu;

struct NodeState {
  const Word* word = nullptr;
  Index parent = kNoNode;
  int dimension = 0;  ///< 2, 3, or 0: nothing in it
  bool drawn = false;
  /// Nothing but unions stands above it: it needs no Boolean.
  bool loose = false;
  /// Within the nearest consumer above, or the world.
  Placement place;
  /// The colour of the outermost `color` above it; alpha is not drawn.
  std::optional<Vec3> color;
};

/// `order` holds the numbers of the nodes that are drawn, each before those below it.
struct Nodes {
  std::vector<NodeState> states;  ///< per node of the tree
  std::vector<Index> order;
};

/// Words that are unknown or refused are reported, and what is left out is told.
Nodes resolve(const Tree& tree, Reporter& reporter);

/// True where the node's children are put together by a union.
bool unites(const Word& word);

}  // namespace overstrike::openscad
