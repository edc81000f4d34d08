#pragma once
// A scene's polyhedron, vertex by vertex and face by face.
#include "core/scene/shapes.h"
#include "scenes/readers/yaml/fields.h"

namespace overstrike::yaml {

Shape read_polyhedron(const Fields& f);

}  // namespace overstrike::yaml
