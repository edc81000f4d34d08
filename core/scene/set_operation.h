#pragma once
// Set operations and trees of them, over whatever has an inside: solids, plane regions.
#include <cstdint>

namespace overstrike {

enum class SetOperation : std::uint8_t { operand, unite, subtract, intersect };

/// A node of a Boolean tree. Nodes stand in preorder: a node's first operand follows it,
/// and each further one begins where the one before it ends. `subtract` takes all others from the
/// first.
struct SolidNode {
  SetOperation operation = SetOperation::operand;
  std::uint32_t body = 0;  ///< of an operand: its number (of a solid: in Scene::bodies)
  std::uint32_t end = 0;   ///< where the nodes below it end; of an operand, the next node
};

}  // namespace overstrike
