#pragma once
// Exact area averages: polygons of known density added into one row of cells.
#include <span>
#include <vector>

#include "core/visibility/eye_table.h"

namespace overstrike {

/// One row of cells, y from 0 to 1 within it. Densities add by the area they cover.
class CellAccumulator {
 public:
  explicit CellAccumulator(int columns);

  void clear();
  /// All of [x0, x1) over the row's whole height: cells inside get the density itself, so that flat
  /// faces stay flat to the bit.
  void add_rectangle(double x0, double x1, double density);
  /// As add_polygon, for a region with straight sides: density times the signed area to the right
  /// of a line from (xa, ya) to (xb, yb), ya <= yb. A region is its left border added and its right
  /// one subtracted. Takes effect at settle().
  void add_border(double xa, double ya, double xb, double yb, double density);
  /// Ends a group of borders that lie in [x0, x1] and whose sum is zero right of x1.
  void settle(double x0, double x1);
  /// A convex polygon whose density is linear in each cell to within what matters; `y_offset` is
  /// the row's top in the coordinates of face.density_at. The polygon's y is within the row (0..1).
  void add_smooth(std::span<const Vec2> polygon, const EyeFace& face, double y_offset);

  /// A run of a scan line, standing for a strip of the row of this height.
  void add_run(const DensityRun& run, double height);

  std::span<const float> finish();

 private:
  void add_piece(double xa, double ya, double xb, double yb, double density);

  int columns_;
  std::vector<double> value_;
  std::vector<double> step_;  ///< differences from cell to cell, before settle()
  std::vector<float> result_;
  std::vector<Vec2> right_, cell_;
};

}  // namespace overstrike
