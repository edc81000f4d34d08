#pragma once
// Shapes made as large as is asked.
#include "scenes/readers/openscad/arguments.h"

namespace overstrike::openscad {

/// What `resize` does to a shape of that size. Each size that is given becomes that; with `auto`,
/// those that are not follow the largest change.
Affine resizing(const Vec3& size, int dimension, const Arguments& arguments);

}  // namespace overstrike::openscad
