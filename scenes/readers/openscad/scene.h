#pragma once
// OpenSCAD's CSG export (docs/openscad.md) -> Scene.
#include <filesystem>
#include <string>
#include <string_view>

#include "scenes/readers/read.h"

namespace overstrike::openscad {

/// Throws InputError with everything that is wrong. `name` stands in messages; files that it names
/// are looked for in `folder`.
ReadResult read_scene(std::string_view text, const std::string& name,
                      const std::filesystem::path& folder);

}  // namespace overstrike::openscad
