#pragma once
// The outlines of a DXF drawing, read as OpenSCAD reads them.
#include <string_view>

#include "scenes/readers/openscad/arguments.h"
#include "scenes/readers/openscad/part.h"

namespace overstrike::openscad {

struct DxfOptions {
  std::string layer;  ///< empty: all
  Vec2 origin{0.0};
  double scale = 1;
};

/// Lines, polylines, circles, arcs and ellipses, in blocks too, joined where their ends are within
/// a thousandth; an open path is closed. Other entities are told. Loops may cross: what lies in an
/// odd number of them is inside. Facets of round ones by the node's $fn, $fa and $fs.
Region read_dxf(std::string_view text, const std::string& name, const DxfOptions& options,
                const Arguments& arguments);

}  // namespace overstrike::openscad
