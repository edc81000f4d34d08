#pragma once
// The bytes of a mesh file.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace overstrike {

/// Judges a file by its first bytes and its size (0: not known, of a pipe); throws InputError.
using FileCheck =
    std::function<void(std::string_view head, std::uint64_t size, const std::string& name)>;

/// Reads a file or a pipe whole, once `check` has seen its beginning: a huge file that is no mesh
/// costs no memory. Throws InputError: what cannot be opened, directories, devices, files that are
/// too large.
std::string read_mesh_file(const std::filesystem::path& path, const FileCheck& check);

}  // namespace overstrike
