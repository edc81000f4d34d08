#pragma once
// The reader of each mesh format: text in memory -> Mesh with welded vertices, at least one face,
// and `lines` for text. They throw InputError; `name` stands in messages.
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/scene/shapes.h"

namespace overstrike {

using Warnings = std::vector<Diagnostic>;

Mesh read_stl(std::string_view bytes, const std::string& name, Warnings& warnings);
Mesh read_off(std::string_view text, const std::string& name, Warnings& warnings);
Mesh read_ply(std::string_view bytes, const std::string& name, Warnings& warnings);
Mesh read_obj(std::string_view text, const std::string& name, Warnings& warnings);

/// Judges a file by its first bytes and its size (in bytes; 0: not known) before it is read whole:
/// throws InputError for what cannot be a file of that format. A huge file that is no mesh costs
/// nothing.
void check_stl(std::string_view head, std::uint64_t size, const std::string& name);
void check_ply(std::string_view head, std::uint64_t size, const std::string& name);
void check_text(std::string_view head, std::uint64_t size, const std::string& name);

}  // namespace overstrike
