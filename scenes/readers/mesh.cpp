#include "scenes/readers/mesh.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

#include "scenes/readers/mesh_assimp.h"
#include "scenes/readers/mesh_build.h"
#include "scenes/readers/mesh_file.h"
#include "scenes/readers/mesh_readers.h"
#include "scenes/readers/source_text.h"

namespace overstrike {
namespace {

/// A format of our own readers; without `read` Assimp's.
struct Format {
  std::string_view name;
  void (*check)(std::string_view head, std::uint64_t size, const std::string& name);
  Mesh (*read)(std::string_view bytes, const std::string& name, Warnings& warnings);
};

void check_not_empty(std::string_view head, std::uint64_t, const std::string& name) {
  if (head.empty()) fail_mesh(name, "the file is empty");
}

constexpr Format kFormats[] = {
    {"stl", check_stl, read_stl},       {"obj", check_text, read_obj},
    {"off", check_text, read_off},      {"ply", check_ply, read_ply},
    {"3mf", check_not_empty, nullptr},  {"glb", check_not_empty, nullptr},
    {"gltf", check_not_empty, nullptr}, {"dae", check_not_empty, nullptr},
    {"fbx", check_not_empty, nullptr},  {"3ds", check_not_empty, nullptr},
    {"x3d", check_not_empty, nullptr},  {"amf", check_not_empty, nullptr},
};

const Format* find_format(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kFormats), std::end(kFormats),
                                         [&](const Format& f) { return f.name == name; });
  return found == std::end(kFormats) ? nullptr : found;
}

const Format& format_of(std::string extension, const std::string& name) {
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (const Format* format = find_format(extension)) return *format;
  std::string known;
  for (const Format& f : kFormats) known += (known.empty() ? "" : ", ") + std::string(f.name);
  fail_mesh(name,
            extension.empty() ? "no format: the name has no extension"
                              : "no mesh format: " + in_quotes(extension),
            "known are " + known);
}

Mesh read_bytes(std::string_view bytes, const Format& format, const std::string& name,
                Warnings& warnings) {
  if (format.read) return format.read(bytes, name, warnings);
  check_not_empty(bytes, bytes.size(), name);
  return read_by_assimp(bytes, std::string(format.name), name);
}

Mesh read_path(const std::filesystem::path& path, const Format& format, Warnings& warnings) {
  std::error_code none;
  if (!format.read && std::filesystem::is_regular_file(path, none)) {
    // Assimp opens what lies beside the file, too.
    if (std::filesystem::file_size(path, none) == 0) fail_mesh(path.string(), "the file is empty");
    return read_by_assimp(path, std::string(format.name));
  }
  return read_bytes(read_mesh_file(path, format.check), format, path.string(), warnings);
}

}  // namespace

void check_text(std::string_view head, std::uint64_t, const std::string& name) {
  if (head.empty()) fail_mesh(name, "the file is empty");
  const std::size_t zero = head.find('\0');
  if (zero == std::string_view::npos) return;
  const TextMark mark = mark_at(head, zero);
  throw InputError(Place{name, mark.line, mark.column}, "is not text: found a zero byte");
}

bool is_mesh_format(std::string_view format) { return find_format(format) != nullptr; }

Mesh read_mesh(const std::filesystem::path& path, std::vector<Diagnostic>& warnings) {
  std::error_code none;
  if (std::filesystem::is_directory(path, none))
    fail_mesh(path.string(), "is a directory, not a mesh file");
  std::string extension = path.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  Mesh mesh = read_path(path, format_of(extension, path.string()), warnings);
  mesh.source = path.string();
  return mesh;
}

Mesh read_mesh_text(std::string_view text, std::string_view format, const std::string& name,
                    std::vector<Diagnostic>& warnings) {
  Mesh mesh = read_bytes(text, format_of(std::string(format), name), name, warnings);
  mesh.source = name;
  return mesh;
}

Scene scene_of_mesh(Mesh mesh, const std::string& name) {
  Scene scene;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec3& v : mesh.polyhedron.vertices) lowest = std::min(lowest, v.z);
  if (!mesh.polyhedron.vertices.empty()) scene.ground_z = lowest;
  scene.light = Direction{-20, 45};
  Body body;
  body.shape = std::make_shared<const Shape>(std::move(mesh));
  body.shading =
      Shading::smooth;  // creases stay, facets that stand for something round do not show
  body.name = name;
  body.place = {name, 0, 0};
  scene.bodies.push_back(std::move(body));
  scene.source = name;
  return scene;
}

}  // namespace overstrike
