#include "core/visibility/shadow_count.h"

#include <algorithm>
#include <numeric>

namespace overstrike {

ShadowCount::ShadowCount(const ProjectedScene& scene, const Shadow& shadow) {
  edges_.reserve(shadow.edges.size());
  for (const ShadowEdge& e : shadow.edges)
    edges_.push_back({to_grid(scene.view, e.a), to_grid(scene.view, e.b), e.winding});
  gather();
}

/// Sorts edges into boundaries: those with a corner in common belong together.
void ShadowCount::gather() {
  std::vector<Index> ends(2 * edges_.size()), group(edges_.size());
  std::iota(ends.begin(), ends.end(), 0), std::iota(group.begin(), group.end(), 0);
  std::sort(ends.begin(), ends.end(), [&](Index e, Index f) {
    const Vec2 p = corner(e), q = corner(f);
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  });
  const auto root = [&](Index e) {
    while (group[e] != e) e = group[e] = group[group[e]];
    return e;
  };
  for (std::size_t i = 1; i < ends.size(); ++i)
    if (corner(ends[i - 1]) == corner(ends[i])) group[root(ends[i - 1] / 2)] = root(ends[i] / 2);
  for (Index e = 0; e < group.size(); ++e) group[e] = root(e);
  members_.resize(edges_.size());
  std::iota(members_.begin(), members_.end(), 0);
  std::stable_sort(members_.begin(), members_.end(),
                   [&](Index e, Index f) { return group[e] < group[f]; });
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (i == 0 || group[members_[i]] != group[members_[i - 1]])
      boundaries_.push_back({Vec2(1e300), Vec2(-1e300), i, i});
    boundaries_.back().end = i + 1;
    boundaries_.back().add(edges_[members_[i]].a);
    boundaries_.back().add(edges_[members_[i]].b);
  }
}

void ShadowCount::shadowed(const GridPoint& a, const GridPoint& b,
                           std::array<Intervals, 2>& parts) {
  const Ruler ruler(a, b);
  changes_[0].clear(), changes_[1].clear();
  const Vec2 low = glm::min(a.xy(), b.xy()) - ruler.error(),
             high = glm::max(a.xy(), b.xy()) + ruler.error();
  for (const Boundary& other : boundaries_) {
    if (other.low.x > high.x || other.low.y > high.y || low.x > other.high.x ||
        low.y > other.high.y)
      continue;
    for (std::size_t k = other.first; k < other.end; ++k) pass(ruler, edges_[members_[k]]);
  }
  for (int side = 0; side < 2; ++side) between_changes(side, parts[side]);
}

void ShadowCount::pass(const Ruler& ruler, const Edge& e) {
  const double a = ruler.side(e.a), b = ruler.side(e.b);
  if ((a > 0 && b > 0) || (a < 0 && b < 0)) return;
  for (int side = 0; side < 2; ++side) {
    const auto right = [&](double s) { return s == 0 ? side != 0 : s > 0; };
    if (right(a) == right(b)) continue;
    changes_[side].push_back(
        {ruler.crossing(e.a.xy(), a, e.b.xy(), b), right(a) ? e.winding : -e.winding});
  }
}

void ShadowCount::between_changes(int side, Intervals& parts) {
  std::vector<Change>& changes = changes_[side];
  std::sort(changes.begin(), changes.end(),
            [](const Change& a, const Change& b) { return a.at < b.at; });
  parts.clear();
  int count = 0;
  double from = 0;
  for (const Change& change : changes) {
    if (count == 0) from = change.at;
    count += change.by;
    if (count == 0) parts.emplace_back(std::max(from, 0.0), std::min(change.at, 1.0));
  }
  unite(parts);
}

}  // namespace overstrike
