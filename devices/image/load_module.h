#pragma once
#include "devices/image/module.h"

namespace overstrike {

/// overstrike_image.so, loaded on first use and kept. Sought in $OVERSTRIKE_MODULES, then in the
/// library directory beside the program's bin/, in the build tree's, and in the configured
/// installation's. Throws WorkError that names where it looked or what the loader said.
const OverstrikeImageModule& image_module();

}  // namespace overstrike
