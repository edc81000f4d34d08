#include "core/visibility/active_faces.h"

#include <algorithm>

namespace overstrike {

ActiveFaces::ActiveFaces(const EyeTable& table)
    : table_(table), position_(table.faces.size(), kNone), shadow_count_(table.covered.size(), 0) {
  for (std::size_t slot = 0; slot < table.covered.size(); ++slot)
    shadow_count_[slot] = table.covered[slot];
}

void ActiveFaces::toggle(Index face) {
  const int crosses = table_.faces[face].may_cross;
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

bool ActiveFaces::shares_plane(Index face) const {
  const Index plane = table_.faces[face].plane;
  return std::any_of(active_.begin(), active_.end(), [&](Index other) {
    return other != face && table_.faces[other].plane == plane;
  });
}

void ActiveFaces::pass(const ScanEdge& edge) {
  if (edge.winding != 0) {
    shadow_count_[edge.shadow_slot] += edge.winding;
    return;
  }
  const Index f = edge.faces[0], g = edge.faces[1];
  if (g == kNone) {
    toggle(f);
    return;
  }
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

void ActiveFaces::pass_back(const ScanEdge& edge) {
  if (edge.winding != 0) {
    shadow_count_[edge.shadow_slot] -= edge.winding;
  } else {
    for (const Index face : edge.faces)
      if (face != kNone) toggle(face);
    candidate_known_ = false;
  }
}

void ActiveFaces::clear() {
  for (const Index face : active_) position_[face] = kNone;
  active_.clear();
  entered_.clear();
  candidate_ = kNone;
  candidate_known_ = true;
  crossing_ = 0;
  for (std::size_t slot = 0; slot < shadow_count_.size(); ++slot)
    shadow_count_[slot] = table_.covered[slot];
}

bool ActiveFaces::shadowed(Index face) const {
  const Index slot = table_.shadow_slot[table_.faces[face].surface];
  return slot != kNone && shadow_count_[slot] != 0;
}

Index ActiveFaces::nearest(double x, double y) const {
  Index best = kNone;
  for (const Index face : active_)
    if (best == kNone || table_.in_front(face, best, x, y)) best = face;
  return best;
}

Index ActiveFaces::seen_at(double x, double y) {
  if (crossing_ > 0 || !candidate_known_) {
    candidate_ = nearest(x, y);
    // What is seen while bodies cross says nothing about the next span.
    candidate_known_ = crossing_ == 0;
  } else {
    for (const Index face : entered_)
      if (candidate_ == kNone || table_.in_front(face, candidate_, x, y)) candidate_ = face;
  }
  entered_.clear();
  return candidate_;
}

}  // namespace overstrike
