#include <algorithm>
#include <cctype>
#include <filesystem>

#include "devices/device.h"
#include "devices/image/image.h"
#include "devices/line_printer/line_printer.h"
#include "devices/null/null.h"
#include "devices/plotter/plotter.h"
#include "devices/terminal/terminal.h"

namespace overstrike {

const std::vector<DeviceKind>& device_kinds() {
  static const std::vector<DeviceKind> kinds = {
      image_device(), line_printer_kind(), null_device(), plotter_kind(), terminal_device(),
  };
  return kinds;
}

const DeviceKind* find_device(std::string_view name) {
  for (const DeviceKind& kind : device_kinds())
    if (kind.name == name) return &kind;
  return nullptr;
}

const DeviceKind* device_for_file(std::string_view output_name) {
  std::string extension = std::filesystem::path(output_name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const DeviceKind& kind : device_kinds())
    if (std::find(kind.extensions.begin(), kind.extensions.end(), extension) !=
        kind.extensions.end())
      return &kind;
  return nullptr;
}

}  // namespace overstrike
