#pragma once
// Fonts by name, as OpenSCAD finds them: through Fontconfig.
#include <string>

namespace overstrike::openscad {

struct FontFile {
  std::string path;  ///< empty when the system has no outline font at all
  int index = 0;     ///< of the face in the file
  std::string family;
  bool substitute = false;  ///< another family than the one asked for
};

/// "Liberation Sans:style=Bold" is a pattern of Fontconfig; empty takes the system's own.
FontFile find_font(const std::string& pattern);

}  // namespace overstrike::openscad
