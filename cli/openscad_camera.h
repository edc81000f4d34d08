#pragma once
// OpenSCAD's own camera string.
#include <string>

#include "core/scene/scene.h"

namespace overstrike {

/// Seven numbers: what is looked at, how the model is turned (degrees round x, y and z; all 0 is
/// from above), from how far. Six: the eye and what it looks at. The picture is what OpenSCAD
/// draws: 22.5 degrees high, or as high at the target in a parallel view. Throws UsageError.
Camera read_openscad_camera(const std::string& text, bool parallel);

}  // namespace overstrike
