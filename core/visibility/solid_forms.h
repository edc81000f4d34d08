#pragma once
// The forms in which Boolean solids are followed along a line of sight.
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/visibility/canonical.h"
#include "core/visibility/solid_options.h"
#include "core/visibility/world_box.h"

namespace overstrike {

/// More elements than the tree has leaves are not looked for where the form is chosen: wherever
/// that was measured, the tree was as fast or faster.
constexpr std::size_t kMostElementsPerLeaf = 1;

/// Counters that are updated at most when each operand that has a leaf in `in` is entered once:
/// those from each of its leaves in `expression` up to the root.
std::size_t most_updates(const SolidExpression& expression, const SolidExpression& in);

/// A union of intersections, or two terms deep with one leaf an operand, whose entry then updates
/// two counters at most: no sum of products has fewer by more than one an operand.
bool has_few_updates(const SolidExpression& expression);

/// The tree as a sum of products where that has fewer such updates, counted for the operands that
/// it has left; docs/tk-experiments.md measures what that chooses. `bounds` has the operands'.
std::optional<SolidExpression> fewer_updates(const SolidExpression& tree,
                                             std::span<const WorldBox> bounds);

/// The canonical input's solids in the form asked for, translucent as they are or as is given;
/// where they are, uncut too. Those that need no change are shared. Throws InputError where a sum
/// of products has too many elements.
std::vector<std::shared_ptr<const CanonicalSolid>> solids_in_form(
    const Canonical& canonical, BooleanForm form, std::optional<double> translucent);

/// The tree with nothing taken from anything: of a difference its first operand.
std::vector<SolidNode> uncut(const std::vector<SolidNode>& nodes);

}  // namespace overstrike
