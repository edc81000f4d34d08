#pragma once
// The plotted sheet against the picture of the same window.
#include "core/scene/scene.h"

namespace overstrike {

struct SheetReport {
  int blocks = 0;    ///< hatched and without lines: compared
  int off = 0;       ///< of them with ink farther from the wish than its bound
  double mean = 0;   ///< ink less wish, on average
  int levels = 0;    ///< levels that fill a block
  int borders = 0;   ///< places where the picture's density makes a step
  int unmarked = 0;  ///< of them without a line near
  int paper = 0;     ///< cells of the picture that are bare, and all about them
  int blots = 0;     ///< of them with ink on the sheet
};

/// Plots `plotted` on A4, emulates the bytes, and compares the sheet with the picture of `pictured`
/// in cells of a quarter of a millimetre, three ways:
///
///   - blocks of 5 mm that no line touches have the ink that the levels nearest to the picture's
///     densities ask for;
///   - where the density of neighbouring cells differs by a quarter of black, a line lies near;
///   - where the picture is bare paper the sheet is.
SheetReport compare_sheet(const Scene& plotted, const Scene& pictured);

}  // namespace overstrike
