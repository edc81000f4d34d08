#pragma once
// Where an operand matters to its solid (TK: primitives are clipped to their products' bounds).
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "core/visibility/world_box.h"

namespace overstrike {

/// Widens `reach`, per operand, by the bounds of the places where it hangs on that operand whether
/// the tree holds: a member of an intersection matters where all others may hold, what is taken
/// from a set where that may. `bounds` are the operands'.
void add_reach(std::span<const SolidNode> nodes, std::span<const WorldBox> bounds,
               std::span<WorldBox> reach);

}  // namespace overstrike
