#pragma once
// What is seen where faces of one plane lie over one another (TK 3.3.4): what the faces are
// decides, nowhere where they are looked at; never the order of input.
#include "core/visibility/canonical.h"

namespace overstrike {

/// True when face f is seen before g: a cut face before others, then the face of the body with the
/// greater density factor, which is the darker one wherever both are flat (they share a normal, so
/// light and shadow); then a flat body's before a smooth one's; then the one with the
/// lexicographically smaller plane, or else vertices, or else number.
bool wins_tie(const Canonical& canonical, Index f, Index g);

}  // namespace overstrike
