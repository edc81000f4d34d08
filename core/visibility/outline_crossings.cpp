#include "core/visibility/outline_crossings.h"

#include <algorithm>

namespace overstrike {

const Passage& OutlineCrossings::over(Index face, const Ruler& ruler) {
  const Canonical& c = scene_.canonical;
  const CanonicalFace& f = c.faces[face];
  bool touched = false;
  for (std::vector<double>& crossings : crossings_) crossings.clear();
  for (Index l = f.first_loop; l < f.end_loop; ++l) {
    corners_.clear();
    bool loop_touched = false;
    for (const Index v : c.loop(l)) {
      corners_.push_back({v, ruler.side(scene_.points[v])});
      loop_touched |= corners_.back().side == 0;
    }
    touched |= loop_touched;
    const std::size_t before = crossings_[0].size();
    cross_loop(ruler, -1, crossings_[0]);
    if (loop_touched)
      cross_loop(ruler, 1, crossings_[1]);
    else
      crossings_[1].insert(crossings_[1].end(), crossings_[0].begin() + before,
                           crossings_[0].end());
  }
  pair_up(crossings_[0], passage_.side[0]);
  if (touched)
    pair_up(crossings_[1], passage_.side[1]);
  else
    passage_.side[1] = passage_.side[0];
  return passage_;
}

/// Corners on the line count as on the side `zero`.
void OutlineCrossings::cross_loop(const Ruler& ruler, int zero,
                                  std::vector<double>& crossings) const {
  const auto right = [&](const Corner& c) { return c.side == 0 ? zero > 0 : c.side > 0; };
  for (std::size_t i = 0, last = corners_.size() - 1; i < corners_.size(); last = i++)
    if (right(corners_[last]) != right(corners_[i]))
      crossings.push_back(crossing(ruler, corners_[last], corners_[i]));
}

/// From the ends in the order of their numbers, so that two faces that share the edge share the
/// crossing to the bit.
double OutlineCrossings::crossing(const Ruler& ruler, Corner p, Corner q) const {
  if (q.vertex < p.vertex) std::swap(p, q);
  const Vec2 from = scene_.points[p.vertex].xy(), to = scene_.points[q.vertex].xy();
  return ruler.crossing(from, p.side, to, q.side);
}

}  // namespace overstrike
