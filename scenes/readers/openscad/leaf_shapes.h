#pragma once
// The shapes that nodes are by themselves, or name a file of.
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scenes/readers/openscad/arguments.h"
#include "scenes/readers/openscad/nodes.h"
#include "scenes/readers/openscad/part.h"

namespace overstrike::openscad {

class LeafShapes {
 public:
  /// Files are looked for in `folder`.
  LeafShapes(const std::filesystem::path& folder, Reporter& reporter)
      : folder_(folder), reporter_(reporter) {}

  std::vector<Part> solid(const Word& word, const Arguments& arguments);
  /// In its place. Outlines may cross and lie on one another; what core has no use for is sorted
  /// out here, once.
  Flat flat(const NodeState& state, const Arguments& arguments);

 private:
  Part imported_mesh(const std::filesystem::path& path);
  Region imported_region(const Word& word, const Arguments& arguments);
  /// Nothing, and an error, where none is named.
  std::optional<std::filesystem::path> file_of(const Word& word, const Arguments& arguments);
  /// What is wrong with a file is told at the node that names it, with the place in the file.
  void refuse(const Word& word, const Arguments& arguments, const InputError& error);

  const std::filesystem::path& folder_;
  Reporter& reporter_;
  std::map<std::string, ShapePtr> meshes_;  ///< by the file's name; null where it cannot be read
};

}  // namespace overstrike::openscad
