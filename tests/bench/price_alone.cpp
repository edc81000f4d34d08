// The one place here that knows how core scans: phase II's table and the scanner that reads it.
#include "core/drawing.h"
#include "core/float_environment.h"
#include "core/visibility/run_shader.h"
#include "core/visibility/scan_line.h"
#include "tests/bench/price_scenes.h"

namespace overstrike::bench {

std::size_t scan_alone(const Prepared& prepared) {
  const FloatEnvironment ours;
  const LineSource source(*prepared.canonical, prepared.view, nullptr,
                          density_tolerance_of(DrawOptions{}.tolerance), 1);
  const std::unique_ptr<RunScanner> scanner = source.scanner();
  std::vector<DensityRun> runs;
  std::size_t count = 0;
  for (int row = 0; row < static_cast<int>(prepared.view.grid.rows); ++row) {
    runs.clear();
    scanner->resolve(row + 0.5, runs);
    count += runs.size();
  }
  return count;
}

}  // namespace overstrike::bench
