// Any bytes are a font whose ink can be measured, or an error. FreeType, which opens it, is not
// built for fuzzing: what is tried is what we do with the outlines it hands over.
#include "core/error.h"
#include "devices/line_printer/glyph_ink.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace overstrike;
  const fuzz::MemoryFile file(fuzz::text_of(data, size));
  try {
    const Alphabet alphabet = measure_alphabet({"fuzz", file.path(), 12, {}}, "AHM", 10, 6);
    for (const Glyph& g : alphabet.glyphs)
      fuzz::expect(g.count > 0 && g.count <= alphabet.cell_pixels && g.spilt >= 0,
                   "ink is a part of the cell");
  } catch (const InputError& error) {
    fuzz::expect(!error.diagnostics().empty(), "an error says what is wrong");
  }
  return 0;
}
