#include "tests/round_trip/sheet.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "emulators/plotter/plotter.h"
#include "tests/plotter/picture.h"
#include "tests/round_trip/picture.h"

namespace overstrike {
namespace {

// A4 on the 7475A: 297 x 210 mm, the origin 10 and 4 mm from the lower left corner, a hard clip of
// 11040 x 7721 units of 0.02488 mm. A margin of 10 mm cuts that at the lower border only.
constexpr double kUnitMm = 0.02488;
constexpr int kUnitsWide = 11040, kUnitsHigh = 7479, kLowestUnit = 242;
constexpr double kLeftMm = 10, kTopMm = 210 - 4 - (kLowestUnit + kUnitsHigh) * kUnitMm;

/// Cells of the picture are 10 units wide and nearly so high.
constexpr int kColumns = 1104, kRows = 748;
constexpr double kCellWideMm = kUnitsWide * kUnitMm / kColumns;
constexpr double kCellHighMm = kUnitsHigh * kUnitMm / kRows;
constexpr double kAspect = kCellWideMm / kCellHighMm;

constexpr double kDotsToTheInch = 127;
constexpr double kDotMm = 25.4 / kDotsToTheInch;

constexpr double kPenMm = 0.3;
constexpr int kLevels = 10;

/// Cells of a block: 4.98 mm.
constexpr int kBlock = 20;
constexpr double kBlockMm = kBlock * kCellWideMm;
/// Hatching keeps half a pen from lines, which are as wide again on either side.
const int kClearDots = static_cast<int>(std::ceil(kPenMm / kDotMm));

/// Lines at 45 degrees, `kPenMm / density` apart, over a square of side L: its chords make a
/// triangle of half-base h = L / sqrt(2) across the lines, whose Fourier transform at the lines'
/// frequencies sums to at most density * spacing^2 / (3 h^2). Where the lines happen to lie can
/// change the ink by no more. Large patches are right to 0.003 (docs/plotter.md).
double bound_of_level(double density) {
  return 2 * kPenMm * kPenMm / (3 * density * kBlockMm * kBlockMm) + 0.003;
}
/// Where tone changes within a block each level has a band of its own, in which the lines can lie
/// well or badly; together no more than half a step between levels was met, or is allowed.
constexpr double kChangingBound = 0.5 / (kLevels - 1);

/// A step of density between neighbouring cells, as only borders make.
constexpr double kStep = 0.25;
/// The border runs through one of the two cells, at most 0.28 mm from the middle of the side
/// between them; tolerance and rounding add 0.06 mm, and a dot is 0.2 mm wide.
constexpr int kBorderDots = 3;

/// Half a line reaches 0.15 mm from the border that it marks: less than this many cells.
constexpr int kBareCells = 2;

int dot_x(double cell) {
  return static_cast<int>(std::lround((kLeftMm + cell * kCellWideMm) / kDotMm));
}
int dot_y(double cell) {
  return static_cast<int>(std::lround((kTopMm + cell * kCellHighMm) / kDotMm));
}

/// Pen 1 draws lines, pen 2 hatches.
GreyPicture sheet_of(const std::string& hpgl, const std::vector<std::string>& pens) {
  emulator::PlotterOptions options;
  options.dpi = kDotsToTheInch;
  options.pens = pens;
  const ScratchFile file(".png");
  emulator::emulate_plotter(hpgl, options, file.path());
  return read_png(file.path());
}

class Comparison {
 public:
  Comparison(const Scene& plotted, const Scene& pictured)
      : picture_(picture_of(pictured, kColumns, kRows, kAspect)),
        hatching_(sheet_of(drawn(plotted, "plotter", {}), {"#ffffff", "#000000"})),
        lines_(sheet_of(drawn(plotted, "plotter", {{"tone", "none"}}), {"#000000"})) {}

  SheetReport run() {
    for (int y = 0; y + kBlock <= kRows; y += kBlock)
      for (int x = 0; x + kBlock <= kColumns; x += kBlock)
        if (!has_lines(x, y)) compare_block(x, y);
    for (int y = kBareCells; y + kBareCells < kRows; ++y)
      for (int x = kBareCells; x + kBareCells < kColumns; ++x) {
        mark_border(x + 1, y + 0.5, picture_.at(x, y) - picture_.at(x + 1, y));
        mark_border(x + 0.5, y + 1, picture_.at(x, y) - picture_.at(x, y + 1));
        if (is_bare(x, y)) look_for_ink(x, y);
      }
    report_.levels = static_cast<int>(filled_.size());
    report_.mean /= std::max(report_.blocks, 1);
    return report_;
  }

 private:
  bool has_lines(int x, int y) const {
    return lines_.coverage(dot_x(x) - kClearDots, dot_y(y) - kClearDots,
                           dot_x(x + kBlock) + kClearDots, dot_y(y + kBlock) + kClearDots) > 0;
  }

  void compare_block(int x, int y) {
    double wish = 0, lightest = 1, darkest = 0;
    for (int j = y; j < y + kBlock; ++j)
      for (int i = x; i < x + kBlock; ++i) {
        const double level = std::round(picture_.at(i, j) * (kLevels - 1)) / (kLevels - 1);
        wish += level / (kBlock * kBlock);
        darkest = std::max(darkest, level);
        lightest = std::min(lightest, level);
      }
    if (darkest == 0) return;
    const double ink = hatching_.coverage(dot_x(x), dot_y(y), dot_x(x + kBlock), dot_y(y + kBlock));
    const bool flat = lightest == darkest;
    if (flat) filled_.insert(lightest);
    ++report_.blocks;
    report_.off += std::abs(ink - wish) > (flat ? bound_of_level(lightest) : kChangingBound);
    report_.mean += ink - wish;
  }

  /// At a place in cells, between two that differ by `step`.
  void mark_border(double x, double y, double step) {
    if (std::abs(step) < kStep) return;
    ++report_.borders;
    for (int j = dot_y(y) - kBorderDots; j < dot_y(y) + kBorderDots; ++j)
      for (int i = dot_x(x) - kBorderDots; i < dot_x(x) + kBorderDots; ++i)
        if (lines_.at(i, j) < 0.5) return;
    ++report_.unmarked;
  }

  bool is_bare(int x, int y) const {
    for (int j = y - kBareCells; j <= y + kBareCells; ++j)
      for (int i = x - kBareCells; i <= x + kBareCells; ++i)
        if (picture_.at(i, j) > 0) return false;
    return true;
  }
  void look_for_ink(int x, int y) {
    const auto ink = [&](const GreyPicture& sheet) {
      return sheet.coverage(dot_x(x), dot_y(y), dot_x(x + 1), dot_y(y + 1));
    };
    ++report_.paper;
    report_.blots += ink(hatching_) + ink(lines_) > 0;
  }

  Picture picture_;
  GreyPicture hatching_;  ///< with the lines drawn in white
  GreyPicture lines_;     ///< without hatching
  std::set<double> filled_;
  SheetReport report_;
};

}  // namespace

SheetReport compare_sheet(const Scene& plotted, const Scene& pictured) {
  return Comparison(plotted, pictured).run();
}

}  // namespace overstrike
