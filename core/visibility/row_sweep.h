#pragma once
// The second level: what is seen along one level.
//
// A plan (row_plan.h) says which bodies' fronts are seen first between which events, and what may
// meet them. One that lies surely before all others is seen as it is, side after side, and what
// lies behind is never walked. Only fronts that may meet are compared face by face. What a stretch
// shows is kept for the levels at which it is surely the same (kept_stretch.h).
#include <vector>

#include "core/visibility/row_plan.h"
#include "core/visibility/span_split.h"

namespace overstrike {

/// One a thread.
class RowSweep {
 public:
  explicit RowSweep(const SweepTable& table);
  /// Appends the pieces on the level, from left to right, within [0, columns); what is no piece is
  /// paper. Neighbours of one face are one piece.
  void resolve(double y, std::vector<SpanPiece>& pieces);
  const FaceOrder& faces() const { return faces_; }
  /// What was cut away of solids on the level; null or empty where nothing was.
  std::vector<SpanPiece>* cut_away() { return planner_.cut_away(); }

 private:
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
  bool show_alone(double y, std::vector<SpanPiece>& pieces);
  void make_plan(double y);
  bool follow_plan(double y, std::vector<SpanPiece>& pieces);
  bool look_at_fronts(double y);
  bool look_at_front(RowPlan::Item& item, double y);
  void keep(RowPlan::Segment& segment, double y);
  void show_kept(const RowPlan::Segment& segment, double y, const Interval& over,
                 std::vector<SpanPiece>& pieces) const;
  bool walk(RowPlan::Item& item, double y);
  void show(RowPlan::Item& item, const Interval& over, std::vector<SpanPiece>& pieces);
  void merge(double y, std::span<const Index> contenders, const Interval& over,
             std::vector<SpanPiece>& pieces);
  const Contender* surely_nearest(double x) const;
  void compare(double y, const Interval& over, std::vector<SpanPiece>& pieces);

  static constexpr int kMostCredit = 256, kPriceOfTrial = 6;
  FaceOrder faces_;
  double columns_;
  FrontWalker walker_;
  RowPlanner planner_;
  StretchKeeper keeper_;
  RowPlan plan_, last_plan_;
  // Levels that were resolved before, and what is kept of them.
  double last_y_ = HUGE_VAL;                        ///< the level before
  double step_ = 0;                                 ///< from that to the one in hand
  double fronts_from_ = 0, fronts_until_ = 0;       ///< levels of the contenders' fronts
  int credit_ = kMostCredit;                        ///< for trials to keep something
  std::vector<KeptPiece> kept_;                     ///< of the plan's segments
  std::vector<std::span<const FrontSide>> steady_;  ///< of the segment that is being kept
  // Of one level.
  std::vector<Index> not_walkable_;  ///< bodies whose front could not be walked
  std::vector<double> event_x_;
  std::vector<RowSide> sides_;
  std::vector<Contender> meeting_;
  std::vector<Index> span_faces_;
  std::vector<SpanPiece> split_;
};

}  // namespace overstrike
