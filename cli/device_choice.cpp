#include "cli/device_choice.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/usage.h"
#include "cli/written.h"

namespace overstrike {
namespace {

const DeviceKind& device_by_name(const std::string& name) {
  if (const DeviceKind* kind = find_device(name)) return *kind;
  const auto names = device_names();
  throw UsageError(fmt::format("-d: expected one of {}, found '{}'{}", fmt::join(names, ", "), name,
                               suggestion(name, names)));
}

/// ".txt .lpt (line-printer), .hpgl .plt (plotter), ..."
std::string known_extensions() {
  std::string text;
  for (const DeviceKind& kind : device_kinds()) {
    if (kind.extensions.empty()) continue;
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", fmt::join(kind.extensions, " "),
                        kind.name);
  }
  return text;
}

const DeviceKind& device_by_extension(const std::string& output) {
  if (const DeviceKind* kind = device_for_file(output)) return *kind;
  const std::string extension = std::filesystem::path(output).extension().string();
  throw UsageError(fmt::format("-o {}: no device draws {}; name one with -d, or use {}", output,
                               extension.empty() ? "a file without extension" : extension,
                               known_extensions()));
}

}  // namespace

std::vector<std::string_view> device_names() {
  std::vector<std::string_view> names;
  for (const DeviceKind& kind : device_kinds()) names.push_back(kind.name);
  return names;
}

DeviceChoice choose_device(const RenderCommand& command, bool stdout_is_terminal) {
  const std::string output = command.output.empty() ? "-" : command.output;
  if (!command.device.empty()) return {&device_by_name(command.device), output};
  if (output != "-") return {&device_by_extension(output), output};
  if (command.output == "-")
    throw UsageError(fmt::format("-o - needs -d: one of {}", fmt::join(device_names(), ", ")));
  if (!stdout_is_terminal)
    throw UsageError(
        fmt::format("standard output is no terminal: name a file with -o, or a device with -d ({})",
                    fmt::join(device_names(), ", ")));
  return {&device_by_name("terminal"), output};
}

void check_settings(const DeviceKind& kind, const Settings& settings) {
  std::vector<std::string_view> known;
  for (const Setting& setting : kind.settings) known.push_back(setting.name);
  for (const auto& [name, value] : settings) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw UsageError(fmt::format("the {} has no setting '{}'{}; it has {}", kind.name, name,
                                 suggestion(name, known), fmt::join(known, ", ")));
  }
}

std::unique_ptr<Device> make_device(const DeviceChoice& choice, const RenderCommand& command,
                                    std::unique_ptr<Transport> transport) {
  try {
    return choice.kind->make(command.settings, choice.output, std::move(transport));
  } catch (const InputError& error) {
    const Diagnostic& first = error.diagnostics().front();
    if (!first.place.file.empty()) throw;  // of a type face or a profile, say
    const std::string text = say_as_written({command.settings, command.options}, first.message);
    throw UsageError(first.hint.empty() ? text : fmt::format("{} ({})", text, first.hint));
  }
}

std::string setting_value(const DeviceKind& kind, const Settings& given, std::string_view name) {
  for (auto it = given.rbegin(); it != given.rend(); ++it) {
    if (it->first == name) return it->second;
  }
  for (const Setting& setting : kind.settings) {
    if (setting.name == name) return std::string(setting.value);
  }
  return {};
}

}  // namespace overstrike
