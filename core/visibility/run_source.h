#pragma once
// What every method that resolves scan lines offers.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/picture.h"

namespace overstrike {

/// How far below a line it is looked at. Where a line lies exactly along edges neither of their
/// sides is its own: the edges of two bodies, their depths and the shadow at their feet, each
/// rounded for itself, would make a picture along it that is nowhere near it. The lines that hold
/// such edges are those that files and grids have names for, and not the ones a hair beside them.
/// So all is decided there: 64 units in the last place of the grid's size, and a projection
/// errs by a few, that of a shadow at a foot by more than 16;
/// at most 6e-11 of a cell on a grid of 4096.
inline double beside_line(double columns, double rows) {
  return std::ldexp(1.0, std::ilogb(std::max({columns, rows, 1.0})) - 46);
}

/// Resolves lines y = const of one picture, in any order. One a thread.
class RunScanner {
 public:
  virtual ~RunScanner() = default;
  /// Appends the runs on the line at y, seen beside_line() below it, sorted, within [0, columns).
  virtual void resolve(double y, std::vector<DensityRun>& runs) = 0;
};

/// A picture ready to be scanned (phases I and II done). Safe to share between threads.
class RunSource {
 public:
  virtual ~RunSource() = default;
  virtual std::unique_ptr<RunScanner> scanner() const = 0;
};

}  // namespace overstrike
