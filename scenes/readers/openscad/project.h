#pragma once
// Solids made flat.
#include "scenes/readers/openscad/part.h"

namespace overstrike::openscad {

/// What of the placed part lies in z = 0.
Region slice(const Part& part, const Affine& place);

/// Where the part stands, seen from above.
Region shadow(const Part& part);

}  // namespace overstrike::openscad
