#pragma once
// Laws of shapes that core holds them to.
#include "core/scene/shapes.h"
#include "scenes/readers/yaml/fields.h"

namespace overstrike::yaml {

/// Reports a law that the shape breaks and its keys alone don't tell, at the key that core names
/// first.
void check_laws(const Fields& f, const Shape& shape);

}  // namespace overstrike::yaml
