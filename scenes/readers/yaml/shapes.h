#pragma once
// The shapes of a scene file -> core's shapes.
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/scene/shapes.h"
#include "scenes/readers/yaml/tree.h"

namespace overstrike::yaml {

/// Mesh files of one scene, each read once.
class MeshFiles {
 public:
  /// Names in the scene are relative to `folder`.
  explicit MeshFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Null after an error.
  ShapePtr read(Reporter&, const Node& name);

 private:
  std::filesystem::path folder_;
  std::map<std::string, ShapePtr> read_;
};

/// True for "box", "torus", ...: what read_shape reads.
bool is_shape(std::string_view key);

/// The shape that `key: value` says. Null after an error.
ShapePtr read_shape(Reporter&, std::string_view key, const Node& value, MeshFiles&);

/// The same; a flat region in several pieces is several polygons. One null after an error.
std::vector<ShapePtr> read_shapes(Reporter&, std::string_view key, const Node& value, MeshFiles&);

}  // namespace overstrike::yaml
