#pragma once
// What each node of the tree is to the others: which are drawn, of what dimension, where they
// stand, and in what colour.
#include <optional>
#include <vector>

#include "core/scene/set_operation.h"
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
  /// Left out for its dimension: to the node above an empty operand.
  bool misfit = false;
  bool in_consumer = false;  ///< a shape is made of it
  /// Nothing but unions stands above it: it needs no Boolean.
  bool loose = false;
  /// Within the nearest consumer above, or the world.
  Placement place;
  /// The colour of the outermost `color` above it; alpha is not drawn.
  std::optional<Vec3> color;
};

/// A node marked by %, and the one that it stands below.
struct Background {
  Index node;
  Index parent;
};

struct Nodes {
  std::vector<NodeState> states;  ///< per node of the tree
  /// The numbers of the nodes that are drawn, each before those below it.
  std::vector<Index> order;
  /// What was left out of it for its mark.
  std::vector<Background> backgrounds;
};

/// Words that are unknown or refused are reported, and what is left out is told.
Nodes resolve(const Tree& tree, Reporter& reporter);

/// The same of what is marked by % in the tree, which `nodes` are the nodes of: `backgrounds` are
/// those that are solids. To those above them and below they are not drawn: each stands for itself.
Nodes resolve_backgrounds(const Tree& tree, const Nodes& nodes, Reporter& reporter);

/// By which the node's children are put together: where no other, a union.
SetOperation operation_of(const Word& word);
bool unites(const Word& word);

}  // namespace overstrike::openscad
