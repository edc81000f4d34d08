// overstrike devices: what there is to draw on.
#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/device_choice.h"
#include "cli/usage.h"

namespace overstrike {
namespace {

std::string listing() {
  std::string text;
  for (const DeviceKind& kind : device_kinds()) {
    text += fmt::format("{:<14} {}\n", kind.name, kind.summary);
    if (!kind.extensions.empty())
      text += fmt::format("{:<14} {}\n", "", fmt::join(kind.extensions, " "));
  }
  return text;
}

std::string settings_of(const DeviceKind& kind) {
  std::string text = fmt::format("{}: {}\n", kind.name, kind.summary);
  if (!kind.extensions.empty()) text += fmt::format("files: {}\n", fmt::join(kind.extensions, " "));
  std::size_t name_width = 7, value_width = 7;
  for (const Setting& setting : kind.settings) {
    name_width = std::max(name_width, setting.name.size());
    value_width = std::max(value_width, setting.value.size());
  }
  text += fmt::format("\n{:<{}}  {:<{}}  meaning\n", "setting", name_width, "default", value_width);
  for (const Setting& setting : kind.settings) {
    text += fmt::format("{:<{}}  {:<{}}  {}\n", setting.name, name_width, setting.value,
                        value_width, setting.meaning);
  }
  return text;
}

}  // namespace

int run(const DevicesCommand& command) {
  if (command.name.empty()) {
    print(listing());
    return kDone;
  }
  const DeviceKind* kind = find_device(command.name);
  if (kind == nullptr) {
    const auto names = device_names();
    throw UsageError(fmt::format("no device '{}'{}; there are {}", command.name,
                                 suggestion(command.name, names), fmt::join(names, ", ")));
  }
  print(settings_of(*kind));
  return kDone;
}

}  // namespace overstrike
