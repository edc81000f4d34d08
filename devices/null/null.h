#pragma once
// The null device: draws nothing, counts what it gets. A template for new devices
// (docs/add-a-device.md) and a way to time everything but the output.
#include "devices/device.h"

namespace overstrike {

DeviceKind null_device();

}  // namespace overstrike
