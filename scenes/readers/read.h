#pragma once
// Files -> Scene.
#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace overstrike {

struct ReadResult {
  Scene scene;
  std::vector<Diagnostic> warnings;
};

/// Reads a scene by its extension: .yaml .yml scenes; .stl .obj .off .ply and what Assimp reads
/// (.3mf .glb .gltf ...): a mesh alone is a scene, with camera, light and ground chosen sensibly.
/// .csg is OpenSCAD's export; .scad is exported by it first, with `definitions` (name=value).
/// Throws InputError with all errors of the file.
ReadResult read_scene(const std::filesystem::path& path,
                      std::span<const std::string> definitions = {});

/// True for a file that another program makes a scene of: definitions are for it.
bool is_program(const std::filesystem::path& path);

/// The same from text in memory. `format` is an extension without its dot; `name` stands in
/// messages; files that the text names are looked for in `folder`.
ReadResult read_scene_text(std::string_view text, std::string_view format, const std::string& name,
                           const std::filesystem::path& folder);

/// "yaml", "stl", ... : what `format` may be.
std::vector<std::string_view> scene_formats();

}  // namespace overstrike
