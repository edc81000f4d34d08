#pragma once
// Area averages of what is seen, exact for straight borders.
//
// Goals: the mean density over each cell, not a sample; flat faces flat to the bit; work by what
// happens in a row.
//
// Steps, for the band of one row:
//  1. Edges that meet the band, horizontal ones too, are gathered into clusters that overlap in x.
//  Between two clusters nothing
//     begins, ends or crosses within the band: a rectangle with one set of active faces.
//  2. In a cluster, the heights at which an edge begins or ends or two edges cross cut the band
//  into slabs. In a slab the
//     edges stand side by side, trapezoids between them, each with one set of active faces.
//  3. A trapezoid (or rectangle) belongs to one face; where bodies cross it is cut along the lines
//  of equal depth, each
//     face keeping the convex part where it is nearest.
//  4. The parts are added with their exact areas.
#include <vector>

#include "core/visibility/active_faces.h"
#include "core/visibility/cell_accumulator.h"
#include "core/visibility/eye_table.h"

namespace overstrike {

/// Resolves rows of one picture, in any order. One a thread.
class CellScanner {
 public:
  explicit CellScanner(const EyeTable& table);

  /// The row's cells; valid until the next call. `edges`, `flat_edges`: at least those that meet
  /// [row, row + 1].
  std::span<const float> resolve(std::int64_t row, const std::vector<Index>& edges,
                                 const std::vector<Index>& flat_edges);

 private:
  /// An edge within the band: y relative to it; a flat edge has edge == kNone.
  struct Clip {
    double xa, ya, xb, yb;
    double low, high;
    Index edge;
  };
  struct Side {
    double xa, xb, middle;
    Index edge;
  };
  void gather(const std::vector<Index>& edges, const std::vector<Index>& flat_edges);
  void cluster(std::size_t first, std::size_t last, double low, double high);
  void find_heights(std::size_t first, std::size_t last);
  void slab(std::size_t first, std::size_t last, double ya, double yb, double low, double high);
  void rectangle(double x0, double x1);
  void trapezoid(const Side& left, const Side& right, double ya, double yb);
  void part(const std::vector<Vec2>& polygon, Index face);
  void share(const std::vector<Vec2>& polygon);
  Index sole_owner(const std::vector<Vec2>& polygon);
  double x_at(const Clip& clip, double y) const;

  const EyeTable& table_;
  ActiveFaces active_;
  CellAccumulator cells_;
  double top_ = 0;
  std::vector<Clip> clips_;
  std::vector<double> heights_;
  std::vector<Side> sides_;
};

}  // namespace overstrike
