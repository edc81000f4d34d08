#pragma once
// The whole contract between core and devices.
//
// Grid coordinates: x to the right in columns, y down in rows, real numbers. Cell (0, 0) is
// [0, 1) x [0, 1); the scan line of a row is its middle. Density 0 is bare paper, 1 the darkest
// ink of the device; reflectance is 1 - density.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/vec.h"

namespace overstrike {

/// Where a picture goes: so many columns and rows of cells of a physical size.
struct Grid {
  double columns = 135;
  double rows = 180;
  /// Physical size of one cell in millimetres; only the ratio matters for the aspect.
  double pitch_x_mm = 2.54;
  double pitch_y_mm = 3.175;
};

/// A family of parallel scan lines over a grid: line i (i = 0, 1, ...) is the line
/// { p : n . p = offset + i * spacing } with n = (-sin angle, cos angle) in grid coordinates.
/// Positions along a line are measured by (cos angle, sin angle) . p. `angle` 0 gives y = const.
struct ScanFamily {
  double angle_deg = 0;
  double spacing = 1;
  double offset = 0.5;
};

enum class Kind : std::uint8_t { lit, shade, shadow, ground_shadow, cut };
std::string_view to_string(Kind);

constexpr std::uint32_t kNoSurface = 0xFFFFFFFFu;

/// What lies on [x0, x1) of a scan line. Runs of a line are sorted, disjoint and not empty; gaps
/// are bare paper. Density is linear in x between the ends.
///
/// `surface` and `body` tell runs of one drawing apart: equal numbers, the same face and the same
/// body. They count the faces and bodies that are left after near clipping: the canonical input
/// itself where nothing is clipped (bodies then in the scene's order, without those that have no
/// shape or no finite place), else what clip() made of it. Both are kNoSurface on the ground.
struct DensityRun {
  double x0, x1;
  double density0, density1;
  std::uint32_t surface;
  std::uint32_t body;
  Kind kind;
};

/// One scan line of a family.
struct RunRow {
  std::int64_t index;  ///< i of ScanFamily
  std::span<const DensityRun> runs;
};

/// Area averages of the picture's density over one row of cells.
struct CellRow {
  std::int64_t row;
  std::span<const float> density;  ///< one a column, 0..1
};

enum class StrokeKind : std::uint8_t {
  contour,
  crease,
  intersection,
  shadow_outline,
  pattern,
  segment,
  cut_outline
};
std::string_view to_string(StrokeKind);

/// A visible line: a polyline in grid coordinates.
struct Stroke {
  std::vector<Vec2> points;
  StrokeKind kind;
  /// As in DensityRun; kNoSurface for segments in space and ground shadow outlines.
  std::uint32_t body;
  int pen = 0;  ///< the pen class the scene gave; 0: the device's choice
  bool hidden = false;
};

}  // namespace overstrike
