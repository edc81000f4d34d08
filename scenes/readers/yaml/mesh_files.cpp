#include "scenes/readers/yaml/mesh_files.h"

#include <memory>
#include <vector>

#include "scenes/readers/mesh.h"

namespace overstrike::yaml {

ShapePtr MeshFiles::read(Reporter& reporter, const Node& name) {
  namespace fs = std::filesystem;
  if (name.kind != NodeKind::scalar || name.text.empty()) {
    reporter.error(name.mark, "file must be the name of a mesh file, found " + describe(name));
    return nullptr;
  }
  const auto known = read_.find(name.text);
  if (known != read_.end()) return known->second;
  ShapePtr& shape = read_[name.text];
  const fs::path path = folder_ / name.text;
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    reporter.error(name.mark,
                   "no mesh file " + in_quotes(name.text) + "; looked for " + path.string());
    return nullptr;
  }
  if (fs::is_directory(path, ignored)) {
    reporter.error(name.mark,
                   "mesh file " + in_quotes(name.text) + " is a directory: " + path.string());
    return nullptr;
  }
  try {
    std::vector<Diagnostic> warnings;
    shape = std::make_shared<const Shape>(read_mesh(path, warnings));
    reporter.append(warnings);
  } catch (const InputError& e) {
    reporter.append(e.diagnostics());
  }
  return shape;
}

}  // namespace overstrike::yaml
