#pragma once
// The second level: which body's front is seen where, along one level.
//
// Fronts enter and leave from left to right. Between two such events the bodies present are the
// same; one that lies surely before all others (body_order.h) is seen as it is, side after side,
// and what lies behind is never walked. Only fronts that may meet are compared face by face.
#include <vector>

#include "core/visibility/body_order.h"
#include "core/visibility/face_order.h"
#include "core/visibility/front_walk.h"
#include "core/visibility/level_bands.h"
#include "core/visibility/loose_edges.h"
#include "core/visibility/span_split.h"

namespace overstrike {

/// What all sweeps of a picture share.
struct SweepTable {
  SweepTable(const Canonical& canonical, const View& view);

  FrontTable fronts;
  LooseEdges loose;
  LevelBands bodies;  ///< that have a front, the ground too
};

/// One a thread.
class RowSweep {
 public:
  explicit RowSweep(const SweepTable& table);
  /// Appends the pieces on the level, from left to right, within [0, columns); what is no piece is
  /// paper. Neighbours of one face are one piece.
  void resolve(double y, std::vector<SpanPiece>& pieces);

 private:
  /// A connected stretch of one body's front.
  struct Item {
    double x0, x1;
    float slack0, slack1;
    Index body;
    Index first, end;  ///< in sides_; first == kNone: not walked yet
    Index at;          ///< the side that the sweep has reached
    Outline outline;
  };
  /// One of the fronts that may meet: the side that is reached, and the depth of its face on the
  /// level, linear in x.
  struct Contender {
    Index item, at, end;
    Index face = kNone;
    double slope = 0, constant = 0, slope_error = 0, constant_error = 0;

    void look(const RowSide* sides, const FaceOrder& order, double y);
    double depth(double x) const { return slope * x + constant; }
    double error(double x) const { return slope_error * std::fabs(x) + constant_error; }
  };
  void collect(double y);
  void collect_loose(Index body, double y);
  void add_stretches(Index body, std::size_t first);
  void add_item(const Item& item);
  bool sweep(double y, std::vector<SpanPiece>& pieces);
  bool interval(double y, double x0, double x1, float slack0, float slack1,
                std::vector<SpanPiece>& pieces);
  void choose();
  int order(Index a, Index b) const {
    return order_of(table_.fronts.bodies[items_[a].body], table_.fronts.bodies[items_[b].body],
                    table_.fronts.view.eye);
  }
  bool walk(Item& item, double y);
  void show(Item& item, double x0, double x1, float slack0, float slack1,
            std::vector<SpanPiece>& pieces);
  void merge(double y, double x0, double x1, float slack0, float slack1,
             std::vector<SpanPiece>& pieces);
  const Contender* surely_nearest(double x) const;
  void compare(double y, double x0, double x1, float slack0, float slack1,
               std::vector<SpanPiece>& pieces);

  const SweepTable& table_;
  FaceOrder faces_;
  FrontWalker walker_;
  std::optional<LooseResolver> loose_;
  std::vector<Index> not_walkable_;  ///< bodies whose front could not be walked on this level
  std::vector<Item> items_;
  std::vector<Index> by_x_;
  std::vector<RowSide> sides_;
  std::vector<Index> active_;
  Index winner_ = kNone;
  std::vector<Index> contenders_;  ///< the winner and what may meet it
  bool chosen_ = false;
  std::vector<Contender> meeting_;
  std::vector<Index> span_faces_;
  std::vector<SpanPiece> split_;
};

}  // namespace overstrike
