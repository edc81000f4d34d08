#pragma once
// How much ink a character leaves, and where: measured on the glyph, not assumed.
//
// A cell is kCellWidth pixels wide and as many high as the pitch asks. A character's ink is a set
// of these pixels; ink of several strikes is the union of theirs, because black on black is no
// blacker. (Scans of two-strike pairs of a real printer agree with the union to 0.02 of darkness,
// while adding the tones is wrong by five times as much.)
//
// What a glyph leaves outside its cell falls into neighbours. Characters that do are not used
// while enough others are there, so that every cell's tone is its own whatever stands beside it.
// What little is left is counted inside, wrapped round: the ink of an endless field of it.
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "devices/line_printer/typeface.h"

namespace overstrike {

constexpr int kCellWidth = 96;

/// A set of a cell's pixels.
class Ink {
 public:
  explicit Ink(int pixels) : words_((pixels + 63) / 64) {}
  void add(int pixel) { words_[pixel / 64] |= std::uint64_t{1} << (pixel % 64); }
  void add(const Ink& other);
  int count() const;
  /// Pixels of the union; neither set is changed.
  int count_with(const Ink& other) const;

 private:
  std::vector<std::uint64_t> words_;
};

struct Glyph {
  char character;
  Ink ink;
  int count;  ///< pixels of ink
  int spilt;  ///< pixels that fell outside of the cell
};

struct Alphabet {
  int cell_pixels = 0;
  std::vector<Glyph> glyphs;  ///< in the order asked; those with ink that a tone may use
};

/// Measures the characters (ASCII) at `cpi` characters and `lpi` lines to the inch. Characters that
/// the font lacks are left out. Throws InputError: not a font, not scalable, no usable character.
Alphabet measure_alphabet(const Typeface& face, std::string_view characters, double cpi,
                          double lpi);

}  // namespace overstrike
