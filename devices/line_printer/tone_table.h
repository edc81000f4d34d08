#pragma once
// Which characters, struck one over another, give which tone.
//
// Level i of n wishes for the ink D * i / (n - 1), D the darkest ink that the strikes reach: levels
// are evenly spaced in reflectance from bare paper to the device's black (DESIGN: density 0 and 1).
// A table obeys three laws: level 0 is blank and level n - 1 the darkest; ink rises strictly; no
// level has more strikes than asked. Among such tables the one is taken that is least in
//
//     sum over levels of (error / step)^2 + (strikes / 64),     step = D / (n - 1):
//
// one strike more must buy what an error of an eighth of a step costs.
#include <span>
#include <string>
#include <vector>

#include "devices/line_printer/glyph_ink.h"

namespace overstrike {

struct ToneTable {
  struct Level {
    std::string strikes;  ///< characters, the one with the most ink first; level 0: none
    int ink;              ///< pixels of the cell
  };
  std::vector<Level> levels;
  int cell_pixels = 1;

  /// Ink of a level as a part of the cell, 0..1.
  double coverage(std::size_t level) const {
    return static_cast<double>(levels[level].ink) / cell_pixels;
  }
  int most_strikes() const;
};

/// `levels` >= 2 of at most `strikes` >= 1 characters. The same input gives the same table
/// everywhere: all is counted in whole pixels. Throws InputError when the alphabet has not so many
/// different tones.
ToneTable make_tone_table(const Alphabet& alphabet, int levels, int strikes);

/// The level of a density: the nearest of `levels` evenly spaced ones, halfway the darker. What is
/// nearer to halfway than float densities are exact (2^-22) counts as halfway, so that rounding
/// noise does not decide. Below 0 and NaN is 0, above 1 is 1.
int nearest_level(float density, int levels);

}  // namespace overstrike
