#pragma once
// linear_extrude and rotate_extrude, facet by facet as OpenSCAD makes them.
#include "scenes/readers/openscad/arguments.h"
#include "scenes/readers/openscad/part.h"

namespace overstrike::openscad {

/// Along z, or along `v`; twisted clockwise by `twist` degrees and scaled towards the top in
/// `slices` steps.
std::vector<Part> linear_extrude(const Arguments& arguments, const Flat& flat);

/// Round z; a full turn begins on the -x side, a part of one at x.
std::vector<Part> rotate_extrude(const Arguments& arguments, const Flat& flat);

}  // namespace overstrike::openscad
