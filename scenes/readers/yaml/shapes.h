#pragma once
// The shapes of a scene file -> core's shapes.
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/scene/shapes.h"
#include "scenes/readers/yaml/mesh_files.h"
#include "scenes/readers/yaml/tree.h"

namespace overstrike::yaml {

/// True for "box", "torus", ...: what read_shape reads.
bool is_shape(std::string_view key);

/// The shape that `key: value` says. Null after an error.
ShapePtr read_shape(Reporter&, std::string_view key, const Node& value, MeshFiles&);

/// The same; a flat region in several pieces is several polygons. One null after an error.
std::vector<ShapePtr> read_shapes(Reporter&, std::string_view key, const Node& value, MeshFiles&);

}  // namespace overstrike::yaml
