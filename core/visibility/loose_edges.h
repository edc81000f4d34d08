#pragma once
// Bodies whose fronts cannot be walked: their edges, for an active edge list (TK, ch. 3 and 4).
#include <array>
#include <span>
#include <vector>

#include "core/visibility/active_list.h"
#include "core/visibility/face_order.h"
#include "core/visibility/level_bands.h"
#include "core/visibility/passing.h"
#include "core/visibility/solid_sweep.h"
#include "core/visibility/span_split.h"

namespace overstrike {

struct LooseEdge {
  LevelLine line;
  std::array<Index, 2> faces;  ///< seen ones; the second may be kNone
  Index body;                  ///< of an operand: its solid's (FrontTable::solid_body)
};

/// The edges of all loose bodies and of all solids, by body.
class LooseEdges {
 public:
  explicit LooseEdges(const FrontTable& table);
  const LooseEdge& operator[](Index i) const { return edges_[i]; }
  /// At least those that meet the level, in order of their numbers.
  std::span<const LevelBands::Item> near(double y) const { return bands_[bands_.band(y)]; }
  /// The levels that are given the same ones.
  std::pair<double, double> levels_near(double y) const {
    if (edges_.empty()) return {-1e300, 1e300};
    const std::size_t band = bands_.band(y);
    return {bands_.low(band), bands_.high(band)};
  }

 private:
  std::vector<LooseEdge> edges_;
  LevelBands bands_;
};

/// The edge as scan lines meet it, or false when it is level or borders no seen face.
bool to_loose_edge(const FrontTable& table, const WingedEdge& edge, Index body, LooseEdge& out);

/// A place on a level where what is seen of a body changes: `face` lies to its right, kNone: none.
struct RowSide {
  double x;
  Index face;
  float slack;  ///< bound on the error of x
};

/// Appends pieces of one body as sides from left to right; a side of no face ends each connected
/// stretch.
void append_sides(const std::vector<SpanPiece>& pieces, std::vector<RowSide>& sides);

/// Resolves a body or a solid alone. One a thread.
class LooseResolver {
 public:
  LooseResolver(const FrontTable& table, const FaceOrder& order, const SolidOptions& solids)
      : table_(table), order_(order), active_(order), solid_(table.canonical, solids) {}

  /// Adds an edge of the body in hand that meets the level.
  void add(const LooseEdge& edge, double y);
  /// Appends what is seen of the body whose edges were added, from left to right. Forgets the
  /// edges.
  void resolve(Index body, double y, std::vector<SpanPiece>& pieces);
  /// What was cut away of solids that were resolved since this was cleared: where the uncut solid
  /// is seen before what is left of it. By solid, from left to right.
  std::vector<SpanPiece>& cut_away() { return cut_away_; }

 private:
  void span(const SpanPiece& over, double y, std::vector<SpanPiece>& pieces);

  const FrontTable& table_;
  const FaceOrder& order_;
  ActiveList<FaceOrder> active_;
  SolidSweep solid_;
  std::vector<Passing> passing_;
  std::vector<SpanPiece> cut_away_;
};

}  // namespace overstrike
