#pragma once
// The line printer: cells become overstruck characters. docs/line-printer.md describes it.
#include "devices/device.h"

namespace overstrike {

/// "line-printer": .txt, .lpt and .asa (with FORTRAN carriage control).
DeviceKind line_printer_kind();

}  // namespace overstrike
