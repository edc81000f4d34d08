#pragma once
// What a stretch of a level shows, kept for the next levels (a certificate, as kinetic data
// structures have them).
//
// Between two events of a plan (row_sweep.h) the sides of the fronts move along straight lines from
// level to level, and so do depth differences along these lines: all are linear in y. What is sure
// at one level and at another is so between. While it is, the stretch shows the same faces in the
// same order, and its levels are found by evaluating the borders of what is seen, nothing of what
// is hidden.
//
// Only what no rounding can change is kept: sides farther apart than both are uncertain, depths
// that doubles can tell, at most one crossing from a side to the next. A kept level has the same
// bits as one that is resolved by itself.
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/visibility/depth_difference.h"
#include "core/visibility/face_order.h"
#include "core/visibility/front_walk.h"

namespace overstrike {

/// A face that a stretch shows, and where its piece ends.
struct KeptPiece {
  SlackLine end;
  Index face;
  Index next;  ///< the face whose depth is equal where the piece ends; kNone: it ends at the line
};

/// Finds what can be kept. One a thread.
class StretchKeeper {
 public:
  /// `columns`: how far levels reach.
  StretchKeeper(const FaceOrder& order, double columns) : order_(order), columns_(columns) {}

  /// Appends the pieces that the stretch from `left` to `right` shows at `y` and, as far as that is
  /// sure, at the levels after it, given all fronts that may be seen in it, with their sides in
  /// order. The result is the level before which they do; or one before `least`, and nothing is
  /// appended.
  double keep(double y, double least, const SlackLine& left, const SlackLine& right,
              std::span<const std::span<const FrontSide>> fronts, std::vector<KeptPiece>& pieces);

 private:
  /// A front, and the side at which the present span begins, or before it.
  struct Passing {
    std::span<const FrontSide> sides;
    std::size_t at;
    Index face() const { return sides[at].face; }
    const FrontSide* next() const { return at + 2 < sides.size() ? &sides[at + 1] : nullptr; }
  };
  bool apart(const SlackLine& a, const SlackLine& b);
  bool begin(const SlackLine& left, const SlackLine& right,
             std::span<const std::span<const FrontSide>> fronts);
  bool stays_before(const SlackLine& left, const Passing& passing);
  bool span(const SlackLine& from, const SlackLine& to, std::vector<KeptPiece>& pieces);
  bool surely_before(Index face, Index other, const SlackLine& line, double offset, double slack);
  bool before(Index face, Index other, const SlackLine& line, double offset);
  bool before_all(Index face, const SlackLine& line, double offset);
  bool before_all_at_crossing(Index face, Index other, double slack);
  void show(Index face, const SlackLine& end, Index next, std::vector<KeptPiece>& pieces) const;
  double levels() const { return std::max(std::fabs(sure_.y), std::fabs(sure_.until)); }
  Index nearest(const SlackLine& line, double offset) const;

  const FaceOrder& order_;
  double columns_;
  SureLevels sure_{};
  std::size_t first_piece_ = 0;  ///< of the stretch
  std::vector<Passing> passing_;
};

}  // namespace overstrike
