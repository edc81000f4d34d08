// Any bytes are a plotter profile or an error. Device and emulator read it each by a reader of its
// own; where both take it they mean the same machine.
#include <optional>

#include "core/error.h"
#include "devices/plotter/profile.h"
#include "emulators/plotter/profile.h"
#include "tests/fuzz/fuzz.h"

namespace overstrike::fuzz {
namespace {

std::optional<PlotterProfile> device_reads(const MemoryFile& file) {
  try {
    const PlotterProfile profile = read_plotter_profile(file.path());
    expect(profile.unit_mm > 0 && profile.pens > 0, "a profile has a unit and pens");
    for (const PlotterPaper& paper : profile.papers)
      expect(paper.clip_x > 0 && paper.clip_y > 0, "paper has room");
    return profile;
  } catch (const InputError& error) {
    expect(!error.diagnostics().empty(), "an error says what is wrong");
    return {};
  }
}

std::optional<emulator::MachineProfile> emulator_reads(const MemoryFile& file,
                                                       const std::string& paper) {
  try {
    return emulator::read_machine(file.path(), paper);
  } catch (const emulator::Error&) {
    return {};
  }
}

void compare(const PlotterProfile& device, const PlotterPaper& paper,
             const emulator::MachineProfile& machine) {
  expect(device.unit_mm == machine.limits.unit_mm, "both read one unit");
  expect(device.pens == static_cast<int>(machine.pens.size()), "both count the pens alike");
  expect(paper.width_mm == machine.width_mm && paper.height_mm == machine.height_mm,
         "both read one size of paper");
  expect(paper.origin_x_mm == machine.origin_x_mm && paper.origin_y_mm == machine.origin_y_mm,
         "both read one origin");
  expect(paper.clip_x == machine.limits.clip_x && paper.clip_y == machine.limits.clip_y,
         "both read one hard clip");
}

}  // namespace
}  // namespace overstrike::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace overstrike::fuzz;
  const MemoryFile file(text_of(data, size));
  const auto device = device_reads(file);
  emulator_reads(file, "A4");
  if (!device) return 0;
  for (const auto& paper : device->papers)
    if (const auto machine = emulator_reads(file, paper.name))
      compare(*device, *device->paper(paper.name), *machine);
  return 0;
}
