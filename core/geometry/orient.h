#pragma once
// Which way faces look.
#include <vector>

#include "core/geometry/winged_edges.h"

namespace overstrike {

struct Orientation {
  std::vector<bool> turn;  ///< per face: it must be reversed; empty when none must
  bool one_sided = false;  ///< some shell (a Moebius strip) has no consistent orientation
};

/// Faces that disagree with their neighbours. Of every connected shell the smaller area is turned.
Orientation consistent_orientation(const Polyhedron& polyhedron,
                                   const std::vector<EdgePair>& edges);

/// Faces that must be reversed because their closed shell has its inside outside: all, when the
/// shells' volumes add up to less than nothing; else shells of negative volume that do not lie
/// within the bounds of another shell, where they would be its cavity. Empty when there are none.
std::vector<bool> inside_out(const Polyhedron& polyhedron, const std::vector<EdgePair>& edges);

}  // namespace overstrike
