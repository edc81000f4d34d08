#pragma once
// What core draws of a tiny scene, with the laws that need nothing but the picture itself.
#include <memory>
#include <vector>

#include "core/drawing.h"
#include "core/visibility/canonical.h"
#include "core/visibility/view.h"
#include "tests/oracle/crossings.h"

namespace overstrike::fuzz {

constexpr Grid kGrid{16, 12, 1, 1};
constexpr double kTolerance = 0.05;

/// A scene's view and canonical input, made once for all that is drawn of it.
struct Prepared {
  explicit Prepared(const Scene& scene);
  Drawing drawing(int threads = 1, Coherence coherence = Coherence::all) const;

  View view;
  std::shared_ptr<const Canonical> canonical;
};

/// How far the place of a point in the grid may be off by the rounding of the world's coordinates
/// and of their products with the view's matrix, each 2 eps of the sum of sizes, for the nearest
/// point that is seen. Much only where a view magnifies without
/// end.
double place_error_of(const Canonical& canonical, const View& view);

struct DrawnLine {
  oracle::Line line;  ///< where it is looked at,
  double beside;      ///< so far beside the line that was asked for (beside_line())
  std::int64_t index;
  double from, to;  ///< where the line lies in the grid
  std::vector<DensityRun> runs;
};

/// The lines of a family. Laws: indices ascend; runs are sorted, disjoint, not empty, finite,
/// within the grid, of densities within 0 and 1.
std::vector<DrawnLine> draw_lines(Drawing& drawing, const ScanFamily& family);

/// The density of every cell, row by row. Laws: every row comes once, in order, of densities
/// within 0 and 1.
std::vector<std::vector<float>> draw_cells(Drawing& drawing);

/// Laws: strokes are polylines of finite points on the page, of a body that there is.
void draw_strokes(Drawing& drawing, std::size_t bodies);

bool same_bits(const DensityRun& a, const DensityRun& b);

/// Law: cells are the means of many lines, to within the tolerance and what lines can miss.
void expect_means(Drawing& drawing, double place_error);

}  // namespace overstrike::fuzz
