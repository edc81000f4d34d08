// Any bytes are a scene or an InputError that says why not; nothing else comes out of a reader.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "scenes/readers/read.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    // A folder that holds nothing: no file that the text names is opened.
    overstrike::read_scene_text(text, OVERSTRIKE_FUZZ_FORMAT, "fuzz", "/nonexistent");
  } catch (const overstrike::InputError& error) {
    if (error.diagnostics().empty()) __builtin_trap();
  }
  return 0;
}
