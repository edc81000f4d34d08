#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "scenes/readers/mesh.h"

namespace overstrike {
namespace {

constexpr std::string_view kFormats[] = {"stl", "obj", "off", "ply", "3mf", "glb", "gltf"};
constexpr const char* kUnread = "mesh files cannot be read yet";

}  // namespace

bool is_mesh_format(std::string_view format) {
  return std::find(std::begin(kFormats), std::end(kFormats), format) != std::end(kFormats);
}

Mesh read_mesh(const std::filesystem::path& path, std::vector<Diagnostic>&) {
  throw InputError(Place{path.string(), 0, 0}, kUnread);
}

Mesh read_mesh_text(std::string_view, std::string_view, const std::string& name,
                    std::vector<Diagnostic>&) {
  throw InputError(Place{name, 0, 0}, kUnread);
}

Scene scene_of_mesh(Mesh mesh, const std::string& name) {
  Scene scene;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec3& v : mesh.polyhedron.vertices) lowest = std::min(lowest, v.z);
  if (!mesh.polyhedron.vertices.empty()) scene.ground_z = lowest;
  scene.light = Direction{-20, 45};
  Body body;
  body.shape = std::make_shared<const Shape>(std::move(mesh));
  body.name = name;
  body.place = {name, 0, 0};
  scene.bodies.push_back(std::move(body));
  scene.source = name;
  return scene;
}

}  // namespace overstrike
