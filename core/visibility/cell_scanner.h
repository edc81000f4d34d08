#pragma once
// Area averages of what is seen, exact for straight borders.
//
// Goals: the mean density over each cell, not a sample; flat faces flat to the bit; work by what
// happens in a row.
//
// Steps, for the band of one row:
//  1. Edges that meet the band, horizontal ones too, are gathered into clusters that overlap in x.
//     Between two clusters nothing begins, ends or crosses within the band: a rectangle with one
//     set of active faces.
//  2. A cluster of one edge is that edge's two sides. A crowded cluster is halved in height, and
//     each half gathered anew: lower bands make narrower clusters, so that edges are looked at
//     again only near to where something happens.
//  3. In a small cluster, the heights at which an edge begins or ends or two edges cross cut the
//  band
//     into slabs. In a slab the edges stand side by side, trapezoids between them, each with one
//     set of active faces.
//  4. A trapezoid (or rectangle) belongs to one face; where bodies cross it is cut along the lines
//  of
//     equal depth, each face keeping the convex part where it is nearest.
//  5. The parts are added with their exact areas.
//
// A row with so many edges, most of them hidden, that none of its columns is without several is
// averaged over scan lines half the tolerance apart instead, for the same promise. Scenes of
// flat-faced bodies, exact whatever the tolerance, are cut exactly up to five times the crowd.
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "core/visibility/active_faces.h"
#include "core/visibility/cell_accumulator.h"
#include "core/visibility/eye_table.h"
#include "core/visibility/run_source.h"
#include "core/visibility/span_split.h"

namespace overstrike {

/// Resolves rows of one picture, in any order. One a thread.
class CellScanner {
 public:
  /// `lines` makes a scanner of the same picture, for crowded rows.
  CellScanner(const EyeTable& table, double tolerance,
              std::function<std::unique_ptr<RunScanner>()> lines);

  /// The row's cells; valid until the next call. `edges`, `flat_edges`: at least those that meet
  /// [row, row + 1].
  std::span<const float> resolve(std::int64_t row, const std::vector<Index>& edges,
                                 const std::vector<Index>& flat_edges);

 private:
  /// An edge within the band: y relative to it; a flat edge has edge == kNone.
  struct Clip {
    double xa, ya, xb, yb;
    double low, high;
    double slope;  ///< dx/dy
    Index edge;
  };
  struct Side {
    double xa, xb, middle;
    Index edge;
  };
  /// Clips of a band lie in clips_[first, end).
  struct Band {
    double ya, yb;
    int halvings = 0;
    int in_vain = 0;  ///< of the last ones, which parted nothing
    std::size_t edges = std::numeric_limits<std::size_t>::max();  ///< of what was halved
  };
  void gather(const std::vector<Index>& edges, const std::vector<Index>& flat_edges);
  void add_clip(Index edge, double ya, double yb);
  bool crowded() const;
  void resolve_band(const Band& band, std::size_t first, double low, double high);
  void cluster(const Band& band, std::size_t first, std::size_t last, double low, double high);
  void halves(const Band& band, std::size_t first, std::size_t last, double low, double high);
  void find_heights(const Band& band, std::size_t first, std::size_t last);
  void slab(std::size_t first, std::size_t last, double ya, double yb, double low, double high);
  void rectangle(const Band& band, double x0, double x1);
  void trapezoid(const Side& left, const Side& right, double ya, double yb);
  void part(std::span<const Vec2> polygon, Index face);
  void share(std::span<const Vec2> polygon);
  Index sole_owner(std::span<const Vec2> polygon);
  static double x_at(const Clip& clip, double y);

  const EyeTable& table_;
  ActiveFaces active_;
  CellAccumulator cells_;
  std::function<std::unique_ptr<RunScanner>()> make_lines_;
  std::unique_ptr<RunScanner> lines_;  ///< made for the first crowded row
  double tolerance_;
  double most_edges_;  ///< on a row that is cut exactly
  std::vector<DensityRun> runs_;
  double top_ = 0;
  std::vector<Clip> clips_;
  std::vector<double> heights_;
  std::vector<Side> sides_;
  std::vector<Vec2> inside_, mine_, kept_;
};

}  // namespace overstrike
