#pragma once
// Solids made flat.
#include <optional>
#include <span>

#include "core/scene/set_operation.h"
#include "scenes/readers/openscad/part.h"

namespace overstrike::openscad {

/// What of the solid lies in z = 0 (`cut`), or where it stands, seen from above. Nothing where that
/// would take too long. `body` of the tree is the part.
///
/// A union stands where the faces of its parts do. Of another solid, each point that is seen from
/// above lies in the plane of some face, so that the sections in all of these planes, each a hair
/// below, cover what it stands on, and nothing else.
std::optional<Flat> projected(std::span<const SolidNode> tree, std::span<const Part> parts,
                              bool cut);

}  // namespace overstrike::openscad
