#pragma once
// The printer's type face, read from data/typefaces by the emulator's own reader.
#include <filesystem>
#include <optional>
#include <string>

namespace overstrike::emulator {

struct PrinterTypeface {
  std::filesystem::path font;
  double points = 12;               ///< at 10 characters to the inch; follows the pitch
  std::optional<double> middle_em;  ///< above the baseline, in the middle of the line; none: of H
};

/// By name in data/typefaces, or a font file (a name with a slash, or ending in .ttf .otf .pfb), at
/// 12 points. Throws Error.
PrinterTypeface find_printer_typeface(const std::string& name);

/// A .typeface file; fonts are looked for beside it. Throws Error.
PrinterTypeface read_printer_typeface(const std::filesystem::path& file);

}  // namespace overstrike::emulator
