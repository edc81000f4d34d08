#pragma once
// Which bodies are operands of which Boolean solids.
#include <vector>

#include "core/visibility/canonical.h"
#include "core/visibility/placed_shapes.h"

namespace overstrike {

/// Of the placed shapes those that become bodies: all but operands that another operand of their
/// solid is the same as, which stands for both. Sets the canonical input's solids and memberships.
/// Throws InputError where an operand is not closed; its open edges are named. (A background goes
/// without it, and a warning names them.)
std::vector<PlacedShape> with_solids(const Scene& scene, const PlacedShapes& placed,
                                     Canonical& canonical, std::vector<Diagnostic>& warnings);

}  // namespace overstrike
