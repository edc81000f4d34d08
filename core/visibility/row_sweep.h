#pragma once
// The second level: which body's front is seen where, along one level.
//
// Fronts enter and leave from left to right. Between two such events the bodies present are the
// same; one that lies surely before all others (body_order.h) is seen as it is, side after side,
// and what lies behind is never walked. Only fronts that may meet are compared face by face.
//
// Which bodies are seen first between which events is a plan that is kept for the next levels: it
// follows from the events' order and from nothing else of the level, so that a level at which the
// same sides meet it in the same order has the same plan.
#include <vector>

#include "core/visibility/body_order.h"
#include "core/visibility/face_order.h"
#include "core/visibility/front_walk.h"
#include "core/visibility/level_bands.h"
#include "core/visibility/level_cover.h"
#include "core/visibility/loose_edges.h"
#include "core/visibility/span_split.h"

namespace overstrike {

/// What all sweeps of a picture share.
struct SweepTable {
  SweepTable(const Canonical& canonical, const View& view, int threads);

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
    Index body;
    Outline outline;   ///< of a front that is walked
    Index first, end;  ///< in sides_; first == kNone: not walked on this level yet
    Index at;          ///< the side that the sweep has reached
    double x0, x1;     ///< on the level for which the plan was made
    double near, far;  ///< its body's depths
  };
  /// Where something may change: a line, and whether it meets the level where the one before does.
  struct Event {
    double x0, y0, slope;
    float slack;
    bool same;
    double x_at(double y) const { return x0 + (y - y0) * slope; }
  };
  struct ItemEnd {
    double x;
    Index item;  ///< kNone: an end of the level itself
    bool begins;
    Event event;
  };
  /// From one event to another: what is seen there first, and what may meet it.
  struct Segment {
    Index from, to;                        ///< in events_
    Index first_contender, end_contender;  ///< in contenders_
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
  struct Interval {
    double x0, x1;
    float slack0, slack1;
  };
  bool plan_holds(double y);
  void make_plan(double y);
  void collect(double y);
  void fetch_ahead(std::size_t at) const;
  void collect_front(Index body, double y);
  void collect_loose(Index body, double y);
  void add_stretches(Index body, std::size_t first);
  void drop_hidden();
  void add_ends();
  void lay_out();
  void choose();
  int order(Index a, Index b) const {
    return order_of(table_.fronts.bodies[items_[a].body], table_.fronts.bodies[items_[b].body],
                    table_.fronts.view.eye);
  }
  bool follow_plan(double y, std::vector<SpanPiece>& pieces);
  bool walk(Item& item, double y);
  void show(Item& item, const Interval& over, std::vector<SpanPiece>& pieces);
  void merge(double y, std::span<const Index> contenders, const Interval& over,
             std::vector<SpanPiece>& pieces);
  const Contender* surely_nearest(double x) const;
  void compare(double y, const Interval& over, std::vector<SpanPiece>& pieces);

  const SweepTable& table_;
  FaceOrder faces_;
  FrontWalker walker_;
  std::optional<LooseResolver> loose_;
  // The plan: what is seen first between which events, for the levels from <= y < until as long as
  // the events keep their order.
  double from_ = 0, until_ = 0;
  std::vector<Item> items_;
  std::vector<Event> events_;
  std::vector<Segment> segments_;
  std::vector<Index> contenders_;
  // Of making a plan.
  LevelCover cover_;
  std::vector<Index> not_walkable_;  ///< bodies whose front could not be walked on this level
  std::vector<Index> meeting_bodies_;
  std::vector<ItemEnd> ends_;
  std::vector<std::pair<double, Index>> by_x_;  ///< of ends_
  std::vector<Index> active_;
  // Of one level.
  std::vector<double> event_x_;
  std::vector<RowSide> sides_;
  std::vector<Contender> meeting_;
  std::vector<Index> span_faces_;
  std::vector<SpanPiece> split_;
};

}  // namespace overstrike
