#pragma once
// The edges of a solid that a level meets, in their order along it.
//
// Each level at which something is due looks at all of them, so what it asks lies side by side.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/visibility/depth_difference.h"

namespace overstrike {

class EdgeOrder {
 public:
  /// Of an edge that begins no span, as the one after it meets the level where it does; and of one
  /// whose span shows more than a face, or not surely the same on the next level.
  static constexpr Index kNoSpan = kNone - 1, kSeveral = kNone - 2;

  std::size_t size() const { return x_.size(); }
  Index node(std::size_t at) const { return others_[at].node; }
  SlackLine line(std::size_t at) const {
    return {x0_[at], y0_[at], others_[at].y1, slope_[at], others_[at].slack};
  }
  double y1(std::size_t at) const { return others_[at].y1; }
  float slack(std::size_t at) const { return others_[at].slack; }
  /// From there something about the edge or the span to its right may be otherwise.
  double until(std::size_t at) const { return until_[at]; }
  /// The face of the span, kNone where there is nothing to see, kNoSpan, or kSeveral.
  Index shows(std::size_t at) const { return shows_[at]; }
  bool has_span(std::size_t at) const { return shows_[at] != kNoSpan; }
  /// Where it meets the level.
  double x(std::size_t at) const { return x_[at]; }
  /// First of those that meet the level where this one does, by what their spans say.
  std::size_t first_beside(std::size_t at) const {
    while (at > 0 && shows_[at - 1] == kNoSpan) --at;
    return at;
  }

  void set_line(std::size_t at, const SlackLine& line);
  void set_until(std::size_t at, double until) { until_[at] = until; }
  void set_shows(std::size_t at, Index shows) { shows_[at] = shows; }
  /// Something about it is otherwise.
  void touch(std::size_t at) { until_[at] = -HUGE_VAL; }
  bool is_due(std::size_t at, double y) const { return until_[at] <= y; }
  /// The first from there on of which something is due; size(): none.
  std::size_t next_due(std::size_t from, double y) const;
  /// The first from there on that shows something else, the beginning of its span apart.
  std::size_t next_showing_other(std::size_t from, Index face) const;
  /// The level at which something is due next.
  double due() const;

  void turn_to(double y);
  /// The first that does not lie left of x. Precondition: they are in order.
  std::size_t first_from(double x) const {
    return static_cast<std::size_t>(std::lower_bound(x_.begin(), x_.end(), x) - x_.begin());
  }
  /// The first one from there on that is not right of the one before it; size(): none.
  std::size_t next_out_of_order(std::size_t from) const;
  void insert(std::size_t at, Index node, const SlackLine& line, double y);
  void erase(std::size_t at);
  /// With the one before it.
  void swap(std::size_t at);
  void clear();

 private:
  template <class Visit>
  void each(const Visit& visit) {
    visit(x_), visit(x0_), visit(y0_), visit(slope_), visit(until_), visit(shows_), visit(others_);
  }
  std::vector<double> x_, x0_, y0_, slope_, until_;
  std::vector<Index> shows_;
  /// What is asked of few of them.
  struct Others {
    double y1;
    float slack;
    Index node;
  };
  std::vector<Others> others_;
};

}  // namespace overstrike
