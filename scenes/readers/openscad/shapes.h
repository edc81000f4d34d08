#pragma once
// The shapes of all nodes, found from the leaves upwards.
#include <filesystem>
#include <vector>

#include "core/scene/scene.h"
#include "scenes/readers/openscad/leaf_shapes.h"
#include "scenes/readers/openscad/nodes.h"
#include "scenes/readers/openscad/part.h"
#include "scenes/readers/openscad/shape_pool.h"

namespace overstrike::openscad {

struct NodeShape {
  bool filled = false;  ///< there may be something in it
  Index filled_children = 0;
  std::vector<Part> parts;  ///< of solids that are leaves or made of their children's
  Flat flat;                ///< of flat nodes; of a loose union nothing, its leaves have it
};

class ShapeBuilder {
 public:
  /// Files are looked for in `folder`.
  ShapeBuilder(const Tree& tree, const Nodes& nodes, const std::filesystem::path& folder,
               Reporter& reporter)
      : tree_(tree), nodes_(nodes), reporter_(reporter), leaves_(folder, reporter) {}

  /// Per node of the tree.
  std::vector<NodeShape> build();

 private:
  void build_node(Index i);
  void build_leaf(Index i);
  void build_consumer(Index i);
  void build_structure(Index i);
  void hull_of(Index i);
  void minkowski_of(Index i);
  void flat_minkowski_of(Index i);
  void project(Index i, bool cut);
  void refuse_not_convex(Index i);
  void resize(Index i, const Arguments& arguments);
  std::vector<Part> parts_below(Index i, Index first, Index end);
  std::vector<Index> operands(Index i) const;
  Flat combined(Index i, SetOperation operation);
  Flat united_children(Index i);
  const NodeState& state(Index i) const { return nodes_.states[i]; }

  const Tree& tree_;
  const Nodes& nodes_;
  Reporter& reporter_;
  LeafShapes leaves_;
  ShapePool pool_;
  std::vector<NodeShape> shapes_;
};

}  // namespace overstrike::openscad
