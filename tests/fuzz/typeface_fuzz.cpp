// Any bytes are a type face's description or an error; where device and emulator both take it they
// mean the same type.
#include <optional>

#include "core/error.h"
#include "devices/line_printer/typeface.h"
#include "emulators/data_files.h"
#include "emulators/line_printer/printer_typeface.h"
#include "tests/fuzz/fuzz.h"

namespace overstrike::fuzz {
namespace {

std::optional<Typeface> device_reads(std::string_view text, const MemoryFile& file) {
  try {
    return parse_typeface(text, file.path());
  } catch (const InputError& error) {
    expect(!error.diagnostics().empty(), "an error says what is wrong");
    return {};
  }
}

std::optional<emulator::PrinterTypeface> emulator_reads(const MemoryFile& file) {
  try {
    return emulator::read_printer_typeface(file.path());
  } catch (const emulator::Error&) {
    return {};
  }
}

}  // namespace
}  // namespace overstrike::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace overstrike::fuzz;
  const MemoryFile file(text_of(data, size));
  const auto device = device_reads(text_of(data, size), file);
  const auto emulator = emulator_reads(file);
  if (!device || !emulator) return 0;
  expect(device->font == emulator->font, "both take the same font");
  expect(device->points == emulator->points, "both read one size");
  expect(device->middle_em == emulator->middle_em, "both read one middle");
  return 0;
}
