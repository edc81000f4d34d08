#pragma once
// What is seen where faces of one plane lie over one another (TK 3.3.4; the rule is DESIGN's): the
// darker, then this order of geometry; never the order of input.
#include "core/visibility/canonical.h"

namespace overstrike {

/// True when face f has the lexicographically smaller plane, or else vertices, or else number.
bool precedes(const Canonical& canonical, Index f, Index g);

}  // namespace overstrike
