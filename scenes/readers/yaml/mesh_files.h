#pragma once
// The meshes that a scene names.
#include <filesystem>
#include <map>
#include <string>
#include <utility>

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

}  // namespace overstrike::yaml
