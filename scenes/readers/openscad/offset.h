#pragma once
// offset(): outlines moved outwards or inwards.
#include "scenes/readers/openscad/arguments.h"
#include "scenes/readers/openscad/part.h"

namespace overstrike::openscad {

/// By `r` with round corners, by `delta` with sharp ones or chamfers. The region's loops are as
/// combine() leaves them.
Region offset(const Arguments& arguments, const Region& region);

}  // namespace overstrike::openscad
