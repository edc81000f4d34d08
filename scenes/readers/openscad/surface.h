#pragma once
// surface(): a height map as a solid.
#include <filesystem>

#include "scenes/readers/openscad/arguments.h"
#include "scenes/readers/openscad/part.h"

namespace overstrike::openscad {

/// Rows of numbers, or a PNG whose luma of 0 to 255 is a height of 0 to 100 and whose last row lies
/// at y = 0. Each cell is four facets about its middle; it stands on z = 0, or 1 below its lowest
/// point. Throws InputError for what is no such file.
std::vector<Part> surface(const Arguments& arguments, const std::filesystem::path& path);

}  // namespace overstrike::openscad
