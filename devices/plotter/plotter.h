#pragma once
// The pen plotter: visible lines and hatched tone as HP-GL (docs/plotter.md).
#include "devices/device.h"

namespace overstrike {

DeviceKind plotter_kind();

}  // namespace overstrike
