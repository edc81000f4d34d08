#pragma once
// A YAML scene file (docs/scene-format.md) -> Scene.
#include <filesystem>
#include <string>
#include <string_view>

#include "scenes/readers/read.h"

namespace overstrike::yaml {

/// Throws InputError with everything that is wrong. `name` stands in messages; mesh files are
/// looked for in `folder`.
ReadResult read_scene(std::string_view text, const std::string& name,
                      const std::filesystem::path& folder);

}  // namespace overstrike::yaml
