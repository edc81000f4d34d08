#pragma once
// text(): outlines of glyphs, set as OpenSCAD sets them.
#include "scenes/readers/openscad/arguments.h"
#include "scenes/readers/openscad/part.h"

namespace overstrike::openscad {

/// One region for each glyph, which may overlap.
std::vector<Region> text_outlines(const Arguments& arguments);

}  // namespace overstrike::openscad
