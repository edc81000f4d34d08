#pragma once
// A type face as data/typefaces describes it: which font file, how large, how high in the line.
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace overstrike {

struct Typeface {
  std::string name;
  std::filesystem::path font;
  double points = 12;  ///< at 10 characters to the inch; follows the pitch
  /// Height above the baseline, in ems, that lies in the middle of the line; none: half the height
  /// of the font's H.
  std::optional<double> middle_em;
};

/// "dejavu-sans-mono" is data/typefaces/dejavu-sans-mono.typeface; a name with a slash or one that
/// ends in .ttf, .otf or .pfb is a font file, at 12 points. Throws InputError: no such type face or
/// font, or an error of the file with its line.
Typeface find_typeface(std::string_view name);

/// The text of a .typeface file; `path` stands in messages, and fonts are looked for beside it.
Typeface parse_typeface(std::string_view text, const std::filesystem::path& path);

}  // namespace overstrike
