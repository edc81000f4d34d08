#pragma once
// The active face list of a scan line: what lies over the present sample span, and which of it is
// seen.
//
// Faces of bodies that cannot pass through one another keep their order while they are active, so
// that a face is compared once, when it enters, with the one that is seen (TK, ch. 4: the candidate
// carried from span to span). Passing an edge between two faces of one surface replaces the
// candidate without a comparison. Only while bodies that may cross are active are depths compared
// at both ends of every span.
//
// `Order` says how faces lie: face_count(), plane_of(face), crosses(face) (whether its body may
// pass through what else is in the list), in_front(f, g, x, y) (f hides g at the point, ties
// decided).
#include <algorithm>
#include <array>
#include <vector>

#include "core/visibility/canonical.h"

namespace overstrike {

template <class Order>
class ActiveList {
 public:
  explicit ActiveList(const Order& order) : order_(order), position_(order.face_count(), kNone) {}

  /// Passes an edge between two faces (the second may be kNone) from left to right, or back.
  void pass(const std::array<Index, 2>& faces) {
    const auto [f, g] = faces;
    if (g == kNone) return toggle(f);
    const bool f_was_active = position_[f] != kNone, g_was_active = position_[g] != kNone;
    const bool replaces = candidate_known_ && f_was_active != g_was_active &&
                          candidate_ == (f_was_active ? f : g) && !shares_plane(candidate_);
    toggle(f);
    toggle(g);
    if (!replaces) return;
    candidate_ = f_was_active ? g : f;
    candidate_known_ = true;
    std::erase(entered_, candidate_);
  }
  void pass_back(const std::array<Index, 2>& faces) {
    for (const Index face : faces)
      if (face != kNone) toggle(face);
    candidate_known_ = false;
  }
  /// What is seen in the present span says nothing about the next one.
  void forget() { candidate_known_ = false; }
  /// Forgets everything: the place left of every edge.
  void clear() {
    for (const Index face : active_) position_[face] = kNone;
    active_.clear();
    entered_.clear();
    candidate_ = kNone;
    candidate_known_ = true;
    crossing_ = 0;
  }

  bool crossing() const { return crossing_ > 0; }
  const std::vector<Index>& faces() const { return active_; }

  /// The face that is seen at the point, or kNone. Precondition: not crossing(), or the caller
  /// knows that no crossing lies in the span around the point.
  Index seen_at(double x, double y) {
    if (crossing_ > 0 || !candidate_known_) {
      candidate_ = nearest(x, y);
      // What is seen while bodies cross says nothing about the next span.
      candidate_known_ = crossing_ == 0;
    } else {
      for (const Index face : entered_)
        if (candidate_ == kNone || order_.in_front(face, candidate_, x, y)) candidate_ = face;
    }
    entered_.clear();
    return candidate_;
  }
  /// The same by comparing all faces.
  Index nearest(double x, double y) const {
    Index best = kNone;
    for (const Index face : active_)
      if (best == kNone || order_.in_front(face, best, x, y)) best = face;
    return best;
  }

 private:
  void toggle(Index face) {
    const int crosses = order_.crosses(face);
    if (position_[face] == kNone) {
      position_[face] = static_cast<Index>(active_.size());
      active_.push_back(face);
      entered_.push_back(face);
      crossing_ += crosses;
      return;
    }
    const Index place = position_[face];
    active_[place] = active_.back();
    position_[active_[place]] = place;
    active_.pop_back();
    position_[face] = kNone;
    crossing_ -= crosses;
    std::erase(entered_, face);
    if (candidate_ == face) candidate_known_ = false;
  }
  /// True when another active face lies in the face's plane: the face is seen by winning a tie, and
  /// its neighbour, in another plane, need not be seen.
  bool shares_plane(Index face) const {
    const Index plane = order_.plane_of(face);
    return std::any_of(active_.begin(), active_.end(), [&](Index other) {
      return other != face && order_.plane_of(other) == plane;
    });
  }

  const Order& order_;
  std::vector<Index> active_;
  std::vector<Index> position_;  ///< per face: its place in active_, or kNone
  std::vector<Index> entered_;   ///< since the candidate was found
  Index candidate_ = kNone;
  bool candidate_known_ = true;
  int crossing_ = 0;
};

}  // namespace overstrike
