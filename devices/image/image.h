#pragma once
// The image device: area averages into any format that OpenImageIO writes (docs/image.md).
#include "devices/device.h"

namespace overstrike {

DeviceKind image_device();

}  // namespace overstrike
