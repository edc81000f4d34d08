#include "scenes/readers/mesh.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

#include "scenes/readers/mesh_build.h"
#include "scenes/readers/mesh_file.h"
#include "scenes/readers/mesh_readers.h"
#include "scenes/readers/source_text.h"

namespace overstrike {
namespace {

struct Format {
  std::string_view name;
  void (*check)(std::string_view head, std::uint64_t size, const std::string& name);
  Mesh (*read)(std::string_view bytes, const std::string& name, Warnings& warnings);
};

constexpr Format kFormats[] = {
    {"stl", check_stl, read_stl},
    {"obj", check_text, read_obj},
    {"off", check_text, read_off},
    {"ply", check_ply, read_ply},
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
  std::string extension = path.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  const Format& format = format_of(extension, path.string());
  const std::string bytes = read_mesh_file(path, format.check);
  Mesh mesh = format.read(bytes, path.string(), warnings);
  mesh.source = path.string();
  return mesh;
}

Mesh read_mesh_text(std::string_view text, std::string_view format, const std::string& name,
                    std::vector<Diagnostic>& warnings) {
  Mesh mesh = format_of(std::string(format), name).read(text, name, warnings);
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
  body.name = name;
  body.place = {name, 0, 0};
  scene.bodies.push_back(std::move(body));
  scene.source = name;
  return scene;
}

}  // namespace overstrike
