#pragma once
// Pictures whose runs are known without core: rectangles of a density, drawn by the plotter device.
#include <string>
#include <vector>

#include "devices/device.h"

namespace overstrike {

/// Density runs linearly from `left` to `right` over the rectangle. In grid coordinates.
struct Patch {
  Vec2 low, high;
  double left = 1, right = 1;
};

/// The HP-GL of the patches and strokes. Patches must not overlap and must be given from left to
/// right where one scan line meets several.
std::string plotted(const Settings& settings, const std::vector<Patch>& patches,
                    const std::vector<Stroke>& strokes);

}  // namespace overstrike
