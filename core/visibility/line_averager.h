#pragma once
// Rows of cells as means of scan lines, for methods and places that know nothing better.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/visibility/cell_accumulator.h"
#include "core/visibility/run_source.h"

namespace overstrike {

/// Adds the row whose top is at y = `top`: lines in the middles of strips half the tolerance high,
/// so that four level borders in one cell are together off by at most the tolerance. `resolve(y,
/// runs)` appends a line's runs; `runs` is scratch.
template <class Resolve>
void average_lines(double top, double tolerance, CellAccumulator& cells,
                   std::vector<DensityRun>& runs, const Resolve& resolve) {
  constexpr int kMostStrips = 64;
  const double wanted = std::ceil(2 / tolerance);
  const int n = wanted < kMostStrips ? std::max(1, static_cast<int>(wanted)) : kMostStrips;
  for (int i = 0; i < n; ++i) {
    runs.clear();
    resolve(top + (i + 0.5) / n, runs);
    for (const DensityRun& run : runs) cells.add_run(run, 1.0 / n);
  }
}

/// Cells of any method that resolves scan lines. One a thread.
class LineAverager {
 public:
  LineAverager(std::unique_ptr<RunScanner> lines, double columns, double tolerance)
      : lines_(std::move(lines)),
        tolerance_(tolerance),
        cells_(static_cast<int>(std::ceil(columns))) {}

  /// The row's cells; valid until the next call.
  std::span<const float> resolve(std::int64_t row) {
    cells_.clear();
    average_lines(static_cast<double>(row), tolerance_, cells_, runs_,
                  [&](double y, std::vector<DensityRun>& runs) { lines_->resolve(y, runs); });
    return cells_.finish();
  }

 private:
  std::unique_ptr<RunScanner> lines_;
  double tolerance_;
  CellAccumulator cells_;
  std::vector<DensityRun> runs_;
};

}  // namespace overstrike
