#pragma once
// Which device draws, and where its bytes go.
#include <memory>
#include <string>
#include <string_view>

#include "cli/commands.h"

namespace overstrike {

struct DeviceChoice {
  const DeviceKind* kind;
  std::string output;  ///< a file, or - for standard output
};

/// By -d, else by the output's extension, else the terminal if standard output is one. Throws
/// UsageError that says what could have been meant.
DeviceChoice choose_device(const RenderCommand& command, bool stdout_is_terminal);

/// Throws UsageError that names the first setting the device does not take.
void check_settings(const DeviceKind& kind, const Settings& settings);

/// The device, set as the command says. Throws UsageError for a setting's value that the device
/// refuses, naming the setting as it was written.
std::unique_ptr<Device> make_device(const DeviceChoice& choice, const RenderCommand& command,
                                    std::unique_ptr<Transport> transport);

/// The device's names as one list, for messages.
std::vector<std::string_view> device_names();

/// The value given for a setting (the last one counts), else the device's default; empty when the
/// device has no such setting.
std::string setting_value(const DeviceKind& kind, const Settings& given, std::string_view name);

}  // namespace overstrike
