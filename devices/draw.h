#pragma once
// From a scene to a device's bytes: the flow of the whole program in one call.
#include "core/drawing.h"
#include "devices/device.h"

namespace overstrike {

struct DrawReport {
  Timings timings;
  std::vector<Diagnostic> warnings;
};

/// Asks the device for its layout, core for what the layout wants, and hands it over.
/// `options.tolerance` <= 0 takes the layout's. Throws InputError (the scene cannot be drawn so)
/// and WorkError (the output failed).
DrawReport draw(const Scene& scene, Device& device, DrawOptions options);

}  // namespace overstrike
