#include "scenes/readers/read.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/float_environment.h"
#include "scenes/readers/mesh.h"
#include "scenes/readers/nearest.h"
#include "scenes/readers/openscad/program.h"
#include "scenes/readers/openscad/scene.h"
#include "scenes/readers/source_text.h"
#include "scenes/readers/yaml/scene.h"

namespace overstrike {
namespace {

// A scene file is written by people or small programs; beyond this it is a mesh in disguise.
constexpr std::size_t kLargestSceneFile = std::size_t{64} << 20;

class File {
 public:
  explicit File(const std::filesystem::path& path)
      : fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY)) {}
  ~File() {
    if (fd_ >= 0) ::close(fd_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  int fd() const { return fd_; }

 private:
  int fd_;
};

[[noreturn]] void fail(const std::string& name, std::string message, std::string hint = {}) {
  throw InputError(Place{name, 0, 0}, std::move(message), std::move(hint));
}

[[noreturn]] void fail_for_size(const std::string& name) {
  fail(name, "is larger than 64 MB", "a large mesh belongs in a mesh file");
}

/// Regular files and pipes are read; directories, devices and sockets are not.
void check_kind(const std::filesystem::path& path) {
  struct ::stat info {};
  if (::stat(path.c_str(), &info) != 0) fail(path.string(), std::strerror(errno));
  if (S_ISDIR(info.st_mode)) fail(path.string(), "is a directory, not a scene file");
  if (!S_ISREG(info.st_mode) && !S_ISFIFO(info.st_mode))
    fail(path.string(), "is neither a file nor a pipe");
}

std::string read_text(const std::filesystem::path& path) {
  std::error_code unknown;  // of pipes, whose size shows in reading
  const auto size = std::filesystem::file_size(path, unknown);
  if (!unknown && size > kLargestSceneFile) fail_for_size(path.string());
  const File file(path);
  if (file.fd() < 0) fail(path.string(), std::strerror(errno));
  std::string text;
  std::size_t used = 0;
  while (true) {
    text.resize(std::max<std::size_t>(65536, 2 * used));
    const ssize_t got = ::read(file.fd(), text.data() + used, text.size() - used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path.string(), std::strerror(errno));
    used += static_cast<std::size_t>(got);
    if (used > kLargestSceneFile) fail_for_size(path.string());
    if (got == 0) break;
  }
  text.resize(used);
  return text;
}

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

bool is_yaml(std::string_view format) { return format == "yaml" || format == "yml"; }

std::string format_of(const std::filesystem::path& path) {
  std::string format = lower_case(path.extension().string());
  if (!format.empty()) format.erase(0, 1);
  return format;
}

[[noreturn]] void unknown_format(const std::string& name, const std::string& format) {
  const std::vector<std::string_view> known = scene_formats();
  std::string all;
  for (const std::string_view f : known) all += (all.empty() ? "" : ", ") + std::string(f);
  std::string hint = did_you_mean(format, known);
  if (!hint.empty()) hint += "; ";
  fail(name,
       format.empty() ? "no format: the name has no extension"
                      : "unknown format " + in_quotes(format),
       hint + "known are " + all);
}

Scene mesh_scene(Mesh mesh, const std::string& name) {
  Scene scene = scene_of_mesh(std::move(mesh), name);
  scene.source = name;
  return scene;
}

}  // namespace

ReadResult read_scene(const std::filesystem::path& path, std::span<const std::string> definitions) {
  const FloatEnvironment ours;
  check_kind(path);
  const std::string format = format_of(path);
  if (is_yaml(format)) return yaml::read_scene(read_text(path), path.string(), path.parent_path());
  if (format == "csg")
    return openscad::read_scene(read_text(path), path.string(), path.parent_path());
  if (format == "scad") return openscad::read_program(path, definitions);
  if (!is_mesh_format(format)) unknown_format(path.string(), format);
  ReadResult result;
  result.scene = mesh_scene(read_mesh(path, result.warnings), path.string());
  return result;
}

bool is_program(const std::filesystem::path& path) { return format_of(path) == "scad"; }

ReadResult read_scene_text(std::string_view text, std::string_view format, const std::string& name,
                           const std::filesystem::path& folder) {
  const FloatEnvironment ours;
  if (is_yaml(format)) {
    if (text.size() > kLargestSceneFile) fail_for_size(name);
    return yaml::read_scene(text, name, folder);
  }
  if (format == "csg") {
    if (text.size() > kLargestSceneFile) fail_for_size(name);
    return openscad::read_scene(text, name, folder);
  }
  if (!is_mesh_format(format)) unknown_format(name, std::string(format));
  ReadResult result;
  result.scene = mesh_scene(read_mesh_text(text, format, name, result.warnings), name);
  return result;
}

std::vector<std::string_view> scene_formats() {
  std::vector<std::string_view> formats{"yaml", "yml", "csg"};
  for (const std::string_view mesh :
       {"stl", "obj", "off", "ply", "3mf", "glb", "gltf", "dae", "fbx", "3ds", "x3d", "amf"})
    if (is_mesh_format(mesh)) formats.push_back(mesh);
  return formats;
}

}  // namespace overstrike
