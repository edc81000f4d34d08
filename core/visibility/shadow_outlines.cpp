// Of the shadow boundaries on a receiver, the parts where shadow ends.
//
//   1. Edges that share corners make closed boundaries. One that lies beside the edge in question
//      adds nothing to the count there.
//   2. Along the straight line through each edge, looked at from both of its sides, the edges of
//      the other boundaries change the count of casters; far away it is zero.
//   3. An edge is an outline where the count is zero on one side of it and not on the other.
//   4. Only what lies on the receiver's face is kept.
#include <algorithm>
#include <numeric>

#include "core/visibility/candidate_lines.h"
#include "core/visibility/edge_resolver.h"

namespace overstrike {
namespace {

struct FlatEdge2 {
  GridPoint a, b;
  int winding;
};

/// A closed boundary: edges_[members[first .. end)], and where they lie.
struct Boundary {
  Vec2 low{1e300}, high{-1e300};
  std::size_t first, end;

  void add(const GridPoint& p) {
    low = glm::min(low, p.xy() - p.error), high = glm::max(high, p.xy() + p.error);
  }
};

/// The count changes here.
struct Change {
  double at;
  int side;  ///< 0 or 1: on which side of the line
  int by;
};

class Outline {
 public:
  Outline(const ProjectedScene& scene, const Shadow& shadow) {
    for (const ShadowEdge& e : shadow.edges)
      edges_.push_back({to_grid(scene.view, e.a), to_grid(scene.view, e.b), e.winding});
    gather();
  }

  /// The parts of edge i where shadow ends.
  Intervals parts(std::size_t i) {
    const Ruler ruler(edges_[i].a, edges_[i].b);
    if (ruler.is_point()) return {};
    changes_.clear();
    const Vec2 from = edges_[i].a.xy(), to = edges_[i].b.xy();
    const Vec2 low = glm::min(from, to) - ruler.error(), high = glm::max(from, to) + ruler.error();
    for (const Boundary& other : boundaries_) {
      if (other.low.x > high.x || other.low.y > high.y || low.x > other.high.x ||
          low.y > other.high.y)
        continue;
      for (std::size_t k = other.first; k < other.end; ++k)
        if (members_[k] != i) pass(ruler, edges_[members_[k]]);
    }
    std::sort(changes_.begin(), changes_.end(),
              [](const Change& a, const Change& b) { return a.at < b.at; });
    return between_changes();
  }

 private:
  Vec2 corner(Index end) const { return (end & 1 ? edges_[end / 2].b : edges_[end / 2].a).xy(); }

  /// Sorts edges into boundaries: those with a corner in common belong together.
  void gather() {
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

  void pass(const Ruler& ruler, const FlatEdge2& e) {
    const double a = ruler.side(e.a), b = ruler.side(e.b);
    if ((a > 0 && b > 0) || (a < 0 && b < 0)) return;
    for (int side = 0; side < 2; ++side) {
      const auto right = [&](double s) { return s == 0 ? side != 0 : s > 0; };
      if (right(a) == right(b)) continue;
      double at;
      if (a == 0)
        at = ruler.parameter(e.a.xy());
      else if (b == 0)
        at = ruler.parameter(e.b.xy());
      else
        at = ruler.parameter(e.a.xy() + (e.b.xy() - e.a.xy()) * (a / (a - b)));
      changes_.push_back({at, side, right(a) ? e.winding : -e.winding});
    }
  }

  Intervals between_changes() const {
    Intervals result;
    int count[2] = {0, 0};
    double from = -1e300;
    const auto close = [&](double to) {
      const double low = std::max(from, 0.0), high = std::min(to, 1.0);
      if ((count[0] == 0) != (count[1] == 0) && low < high) result.emplace_back(low, high);
      from = to;
    };
    for (const Change& change : changes_) {
      close(change.at);
      count[change.side] += change.by;
    }
    close(1e300);
    unite(result);
    return result;
  }

  std::vector<FlatEdge2> edges_;
  std::vector<Index> members_;
  std::vector<Boundary> boundaries_;
  std::vector<Change> changes_;
};

/// The ground ends at the near plane.
void keep_beyond_near_plane(const ProjectedScene& scene, SightLine& line) {
  if (!scene.view.near_plane) return;
  const Interval beyond = positive_part(scene.height(scene.near_plane(), line.a.world),
                                        scene.height(scene.near_plane(), line.b.world));
  line.within = common(line.within, {{line.in_grid(beyond.first), line.in_grid(beyond.second)}});
}

}  // namespace

void add_shadow_outlines(const ProjectedScene& scene, const FaceIndex& index,
                         const std::vector<Shadow>& shadows, std::vector<SightLine>& lines) {
  const Canonical& c = scene.canonical;
  const std::vector<char> curved = curved_bodies(c);
  const bool any_curved =
      std::count(curved.begin(), curved.end(), 0) < static_cast<std::ptrdiff_t>(curved.size());
  EdgeResolver resolver(scene, index);
  for (const Shadow& shadow : shadows) {
    const bool on_ground = shadow.receiver == c.faces.size();
    if (on_ground ? !scene.has_ground() : !scene.seen(shadow.receiver)) continue;
    Outline outline(scene, shadow);
    for (std::size_t i = 0; i < shadow.edges.size(); ++i) {
      const ShadowEdge& e = shadow.edges[i];
      SightLine line{{e.a, to_grid(scene.view, e.a), kNone},
                     {e.b, to_grid(scene.view, e.b), kNone},
                     kNoPlanes,
                     StrokeKind::shadow_outline,
                     on_ground ? kNoSurface : c.faces[shadow.receiver].body};
      line.planes[0] = on_ground ? scene.ground() : c.faces[shadow.receiver].plane;
      if (!on_ground) line.solids[0] = c.membership(line.body).solid;
      line.pen = on_ground ? 0 : c.bodies[line.body].pen;
      line.curved = any_curved;
      line.within = outline.parts(i);
      if (on_ground)
        keep_beyond_near_plane(scene, line);
      else if (!line.within.empty())
        line.within = common(line.within, resolver.inside(line, shadow.receiver));
      if (!line.within.empty()) lines.push_back(std::move(line));
    }
  }
}

}  // namespace overstrike
