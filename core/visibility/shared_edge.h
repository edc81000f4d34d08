#pragma once
// The edge between two faces that are seen beside one another.
#include "core/visibility/canonical.h"

namespace overstrike {

/// The edge in which the body of one of the faces bends from its plane into the other's; null where
/// neither does. Bodies that lie on one another share planes, so that the faces may be of two. An
/// edge that is smooth goes before a crease.
const WingedEdge* shared_edge(const Canonical& c, Index f, Index g);

}  // namespace overstrike
