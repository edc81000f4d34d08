#pragma once
// The terminal device: the picture as text, light on dark (docs/terminal.md).
#include "devices/device.h"

namespace overstrike {

DeviceKind terminal_device();

}  // namespace overstrike
