#pragma once
// The set operations below a node, as core has them.
#include <functional>
#include <vector>

#include "core/scene/scene.h"
#include "scenes/readers/openscad/shapes.h"

namespace overstrike::openscad {

/// In preorder, from `root` down. What is empty is left out: it is in unions, or a tool, as where
/// it decides the operation is empty itself; a node with one operand is that operand. A root that
/// is no set operation unites its parts, or its children. `operand` gives the number of each part
/// of a leaf.
std::vector<SolidNode> solid_tree(
    const Tree& tree, const Nodes& nodes, const std::vector<NodeShape>& shapes, Index root,
    const std::function<Index(Index node, const Part& part)>& operand);

}  // namespace overstrike::openscad
