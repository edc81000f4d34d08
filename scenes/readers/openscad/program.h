#pragma once
// OpenSCAD programs (.scad), which OpenSCAD itself turns into .csg.
#include <filesystem>
#include <span>
#include <string>

#include "scenes/readers/read.h"

namespace overstrike::openscad {

/// Runs `openscad` (found in PATH) with the definitions, each name=value. What it says with a line
/// of the program is told with that place. Throws InputError; WorkError when it is not installed.
ReadResult read_program(const std::filesystem::path& path,
                        std::span<const std::string> definitions);

/// What OpenSCAD printed, as diagnostics: its errors and warnings, with their lines where they are
/// in `path`.
std::vector<Diagnostic> said(std::string_view output, const std::filesystem::path& path);

}  // namespace overstrike::openscad
