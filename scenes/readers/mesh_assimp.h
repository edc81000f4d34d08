#pragma once
// Meshes of the formats that Assimp reads for us. The library takes some milliseconds to load,
// which a scene without such a mesh should not pay: it is loaded by the first one.
#include <filesystem>
#include <string>
#include <string_view>

#include "scenes/readers/mesh_readers.h"

namespace overstrike {

/// All meshes of the file in their places, as one, Z up; in single precision. Buffers that the file
/// names are looked for beside it. Throws InputError without a place in the file, which Assimp does
/// not tell; WorkError if the library cannot be loaded. `format`: the extension in lower case.
Mesh read_by_assimp(const std::filesystem::path& path, const std::string& format);

/// The same from memory; what the text names cannot be found.
Mesh read_by_assimp(std::string_view bytes, const std::string& format, const std::string& name);

}  // namespace overstrike
