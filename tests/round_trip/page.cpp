#include "tests/round_trip/page.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "emulators/line_printer/line_printer.h"
#include "tests/plotter/picture.h"
#include "tests/round_trip/picture.h"

namespace overstrike {
namespace {

constexpr int kColumns = 135, kRows = 180;
constexpr double kDotsToTheInch = 80;
constexpr int kCellWide = 8, kCellHigh = 10;
/// A cell of 1/10 x 1/8 inch.
constexpr double kAspect = 0.8;
/// The page's grid is in millimetres, the picture's has no unit: densities can differ by rounding.
constexpr double kHalfwayBound = 1e-5;

GreyPicture page_of(const Scene& scene) {
  const std::string bytes = drawn(scene, "line-printer", {{"size", "135x180"}, {"lpi", "8"}});
  emulator::LinePrinterOptions options;
  options.lpi = 8, options.dpi = kDotsToTheInch, options.columns = kColumns, options.margin_in = 0;
  const ScratchFile file(".png");
  const auto report = emulator::emulate_line_printer(bytes, options, file.path());
  if (report.lines != kRows || report.pages != 1 || !report.warnings.empty())
    throw std::runtime_error("not one page of 180 lines");
  GreyPicture page = read_png(file.path());
  if (page.width != kColumns * kCellWide || page.height != kRows * kCellHigh)
    throw std::runtime_error("cells of the page are not whole dots");
  return page;
}

}  // namespace

PageReport compare_page(const Scene& printed, const Scene& pictured) {
  const GreyPicture page = page_of(printed);
  const Picture picture = picture_of(pictured, kColumns, kRows, kAspect);
  PageReport report;
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kColumns; ++x) {
      const double level = picture.at(x, y) * (kPrinterLevels - 1);
      if (std::abs(level - std::floor(level) - 0.5) < kHalfwayBound) {
        ++report.halfway;
        continue;
      }
      const double ink =
          page.coverage(x * kCellWide, y * kCellHigh, (x + 1) * kCellWide, (y + 1) * kCellHigh);
      const double error = std::abs(ink - kStep * std::round(level));
      ++report.cells;
      report.off += error > kToneBound;
      report.worst = std::max(report.worst, error);
      report.inked += ink > kStep / 2 ? 1.0 / (kColumns * kRows) : 0;
    }
  }
  return report;
}

}  // namespace overstrike
