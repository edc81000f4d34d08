#pragma once
// Tone by parallel lines: each level of tone has its own family of scan lines, and draws the parts
// of the runs on them whose density is nearest to it (docs/plotter.md).
#include <cstdint>
#include <span>
#include <vector>

#include "core/picture.h"

namespace overstrike {

struct Hatching {
  int levels = 10;        ///< of tone, paper (level 0) included
  double pen_width = 12;  ///< in grid units
  double angle_deg = 0;   ///< of the lines in the grid: y down
};

/// What `level` (1 .. levels - 1) stands for.
double level_density(const Hatching&, int level);

/// The level nearest to a density; the darker one half-way between two.
int nearest_level(const Hatching&, double density);

/// The lines of a level: spacing = pen width / density, so that ink covers that part of the paper.
/// The solid level's lie closer by what rounding to plotter units can pull two neighbours apart.
ScanFamily hatch_family(const Hatching&, int level);

/// One scan line of a family, for ends of ink in plotter units (whole grid coordinates).
class HatchLine {
 public:
  HatchLine(const ScanFamily& family, std::int64_t index);
  /// The whole coordinates nearest to the line (within half a unit in y, or in x for a steep line)
  /// among those within half a unit of position `x` in the other coordinate. So both ends of a
  /// piece stray to the same side, and the pieces of one line lie in one line at 0, 45, 90 degrees.
  Vec2 nearest_unit(double x) const;

 private:
  Vec2 along_, foot_;
};

/// A line of ink between two positions along a scan line.
struct HatchPiece {
  double x0, x1;
  friend bool operator==(const HatchPiece&, const HatchPiece&) = default;
};

/// The centre lines of the ink that `level` puts on a scan line: the parts of the runs in its band
/// of density, split exactly at the borders of the band, parts that touch made one, each shorter
/// by half a pen at both ends, so that the pen's round ends stay inside. Parts no longer than the
/// pen is wide are left out. Appends nothing, replaces `pieces`.
void hatch_pieces(const Hatching&, int level, std::span<const DensityRun> runs,
                  std::vector<HatchPiece>& pieces);

}  // namespace overstrike
