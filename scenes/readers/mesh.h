#pragma once
// Mesh files -> Mesh. Readers of our own for STL (ASCII and binary), OBJ, OFF, PLY (ASCII, binary
// little and big endian): double precision, errors with file:line:column (binary: the byte offset
// in the message). Assimp for the rest, loaded only when it is needed.
#include <filesystem>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/scene/scene.h"

namespace overstrike {

/// Throws InputError. `format` as in read_scene_text. Equal vertices (bit for bit after the file's
/// own rounding) become one.
Mesh read_mesh(const std::filesystem::path& path, std::vector<Diagnostic>& warnings);
Mesh read_mesh_text(std::string_view text, std::string_view format, const std::string& name,
                    std::vector<Diagnostic>& warnings);
bool is_mesh_format(std::string_view format);

/// A scene of one mesh: the body as it stands, shaded smoothly between its creases, seen from
/// azimuth -60, elevation 25, lit from azimuth -20, elevation 45, on a ground under its lowest
/// point.
Scene scene_of_mesh(Mesh mesh, const std::string& name);

}  // namespace overstrike
