#pragma once
// The forms in which Boolean solids are followed along a line of sight.
#include <memory>
#include <optional>
#include <vector>

#include "core/visibility/canonical.h"
#include "core/visibility/solid_options.h"

namespace overstrike {

/// A sum of products has few elements while it has no more than the tree has leaves: each operand
/// that is entered or left then changes no more counters than in the tree, where those of the terms
/// above may change besides. By counting, not by measuring.
constexpr std::size_t kFewElementsPerLeaf = 1;

/// The canonical input's solids in the form asked for, translucent as they are or as is given;
/// where they are, uncut too. Those that need no change are shared. Throws InputError where a sum
/// of products has too many elements.
std::vector<std::shared_ptr<const CanonicalSolid>> solids_in_form(
    const Canonical& canonical, BooleanForm form, std::optional<double> translucent);

/// The tree with nothing taken from anything: of a difference its first operand.
std::vector<SolidNode> uncut(const std::vector<SolidNode>& nodes);

}  // namespace overstrike
