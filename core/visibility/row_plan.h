#pragma once
// Which body's front is seen where along one level.
//
// Fronts enter and leave from left to right. Between two such events the bodies present are the
// same. Which of them are seen first follows from the events' order and from nothing else of the
// level, so that a level at which the same sides meet it in the same order has the same plan.
#include <vector>

#include "core/visibility/body_order.h"
#include "core/visibility/face_order.h"
#include "core/visibility/front_walk.h"
#include "core/visibility/kept_stretch.h"
#include "core/visibility/level_bands.h"
#include "core/visibility/level_cover.h"
#include "core/visibility/loose_rows.h"

namespace overstrike {

/// What all sweeps of a picture share.
struct SweepTable {
  SweepTable(const Canonical& canonical, const View& view, int threads,
             const SolidOptions& solid_options);

  FrontTable fronts;
  LooseEdges loose;
  LevelBands bodies;  ///< that have a front, the ground too
  SolidOptions solids;
};

/// For the levels from <= y < until, as long as the events keep their order.
struct RowPlan {
  /// A connected stretch of one body's front.
  struct Item {
    Index body;
    Outline outline;           ///< of a front that is walked
    Index first = kNone, end;  ///< its sides on the level in hand; kNone: not walked yet
    Index at;                  ///< the side that the sweep has reached
    double x0, x1;             ///< where it begins and ends on the level that the plan was made for
    double near, far;          ///< of the body's depths
  };
  /// Where something may change: a line, and whether it meets the level where the one before does.
  struct Event {
    SlackLine line;
    bool same;
  };
  /// From one event to another: what is seen there first, and what may meet it.
  struct Segment {
    Index from, to;                        ///< in events
    Index first_contender, end_contender;  ///< in contenders
    // What it shows at the levels kept_from <= y < kept_until, where known.
    double kept_from = 0, kept_until = 0;
    Index first_kept = 0, end_kept = 0;
    double try_at = -HUGE_VAL;  ///< the level at which keeping is tried again

    bool is_kept(double y) const { return kept_from <= y && y < kept_until; }
  };

  double from = 0, until = 0;
  std::vector<Item> items;
  std::vector<Event> events;
  std::vector<Segment> segments;
  std::vector<Index> contenders;  ///< items
  double kept_until = -HUGE_VAL;  ///< nothing is kept from there

  std::span<const Index> contenders_of(const Segment& s) const {
    return {contenders.data() + s.first_contender, contenders.data() + s.end_contender};
  }
  /// False for the level in hand alone.
  bool lasts() const { return from < until; }
  /// Finds where the events meet the level.
  bool holds(double y, std::vector<double>& event_x) const;
  /// What a segment of another plan shows is shown by one that has the same lines at its ends and
  /// the same contenders. `event_x`: where the events meet the level.
  void take_kept(const RowPlan& before, double y, const std::vector<double>& event_x);
  void forget_kept();

 private:
  bool same_stretch(const Segment& mine, const RowPlan& before, const Segment& old) const;
};

/// One a thread.
class RowPlanner {
 public:
  RowPlanner(const SweepTable& table, const FaceOrder& faces, FrontWalker& walker)
      : table_(table),
        walker_(walker),
        loose_(table.fronts, table.loose, faces, table.solids),
        cover_(table.fronts.columns) {}

  /// The plan of a level. Bodies that have no front there, and those of `not_walkable`, are
  /// resolved by their edges; their sides are left in `sides`, and the plan does not last.
  void make(double y, std::span<const Index> not_walkable, RowPlan& plan,
            std::vector<RowSide>& sides, std::vector<double>& event_x);
  /// What is seen on a level that meets nothing but one body or solid that is resolved by its
  /// edges, and needs no plan: pieces from left to right, good until the next call. Null: make one.
  const std::vector<SpanPiece>* alone(double y);
  /// What was cut away of solids on the level in hand (LooseRows).
  std::vector<SpanPiece>* cut_away() { return loose_.cut_away(); }

 private:
  struct ItemEnd {
    double x;
    Index item;  ///< kNone: an end of the level itself
    bool begins;
    SlackLine line;
  };
  void collect(double y);
  void fetch_ahead(std::size_t at) const;
  void collect_front(Index body, double y);
  void collect_loose(Index body);
  void add_stretches(Index body, const std::vector<SpanPiece>& pieces);
  void drop_hidden();
  void add_ends();
  void lay_out(std::vector<double>& event_x);
  void choose();
  int order(Index a, Index b) const;

  const SweepTable& table_;
  FrontWalker& walker_;
  LooseRows loose_;
  // The plan that is being made.
  RowPlan* plan_ = nullptr;
  std::span<const Index> not_walkable_;
  std::vector<RowSide>* sides_ = nullptr;
  LevelCover cover_;
  std::vector<Index> meeting_bodies_;
  std::vector<ItemEnd> ends_;
  std::vector<std::pair<double, Index>> by_x_;  ///< of ends_
  std::vector<Index> active_;
};

}  // namespace overstrike
