#pragma once
// The printed page against the picture of the same grid.
#include "core/scene/scene.h"

namespace overstrike {

struct PageReport {
  int cells = 0;     ///< compared
  int halfway = 0;   ///< left out: nearly halfway between two levels
  int off = 0;       ///< cells whose ink is not the tone wished for, within kToneBound
  double worst = 0;  ///< largest distance of a cell's ink from its wish
  double inked = 0;  ///< part of the cells that is not bare paper
};

/// Docs/line-printer.md, DejaVu Sans Mono at 8 lines to the inch: the darkest of 20 levels covers
/// 0.906 of a cell, and no level lies farther than 0.12 of a step from its wish.
constexpr double kDarkest = 0.906;
constexpr int kPrinterLevels = 20;
constexpr double kStep = kDarkest / (kPrinterLevels - 1);
/// To which printing and measuring again add at most 0.004 of a cell (tests/line_printer).
constexpr double kToneBound = 0.12 * kStep + 0.004;

/// Prints `printed` (135 x 180 cells, 8 lines to the inch), emulates the bytes, and compares the
/// ink of every cell with what the picture of `pictured` wishes for it: the darkest ink times the
/// level nearest to the cell's density.
PageReport compare_page(const Scene& printed, const Scene& pictured);

}  // namespace overstrike
