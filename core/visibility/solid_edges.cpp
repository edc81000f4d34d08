#include "core/visibility/solid_edges.h"

#include <algorithm>
#include <optional>

#include "core/visibility/shared_edge.h"
#include "core/visibility/tie.h"

namespace overstrike {
namespace {

const Interval kEverywhere{-1e300, 1e300};

/// What is seen of a solid beside the line, on one side.
struct Beside {
  Index face = kNone;  ///< in whose plane the line lies; kNone: hidden, or farther
  bool hidden = false;
};

/// The surface of one solid along the line.
class Surface {
 public:
  Surface(const Canonical& canonical, const std::vector<SolidSight::Part>& shown, Index solid)
      : canonical_(canonical) {
    for (const SolidSight::Part& part : shown)
      if (part.solid == solid) parts_.push_back(part);
  }

  /// Calls visit(interval, right, left) from one change to the next.
  template <class Visit>
  void along(double sliver, const Visit& visit) const {
    std::vector<double> ends;
    for (const SolidSight::Part& part : parts_)
      ends.push_back(part.over.first), ends.push_back(part.over.second);
    std::sort(ends.begin(), ends.end());
    double from = ends.empty() ? 0 : ends.front();
    for (const double to : ends) {
      // What is shorter goes to what follows.
      if (!(to - from > sliver)) continue;
      const double middle = from + (to - from) / 2;
      visit(Interval{from, to}, at(0, middle), at(1, middle));
      from = to;
    }
  }

  /// Where it is seen in a plane that the line lies in, on one side at least. A line on one plane
  /// is not there where but another's edge runs through it.
  Intervals there(const SightLine& line) const {
    const bool on_one_plane = line.planes[1] == kNone;
    Intervals result;
    for (const SolidSight::Part& part : parts_) {
      if (part.hides) continue;
      if (on_one_plane && !line.lies_in(canonical_.faces[part.face].plane)) continue;
      result.push_back(part.over);
    }
    unite(result);
    return result;
  }

 private:
  Beside at(int side, double t) const {
    for (const SolidSight::Part& part : parts_)
      if (part.side == side && part.over.first <= t && t < part.over.second)
        return part.hides ? Beside{kNone, true} : Beside{part.face, false};
    return {};
  }

  const Canonical& canonical_;
  std::vector<SolidSight::Part> parts_;
};

/// What is drawn at one place of a line, and whose it is.
struct Edge {
  StrokeKind kind;
  Index body;
};

/// Where the surface bends. Between two planes in which an operand that is seen has an edge it is
/// as that edge, whatever else runs along it: the line may be where another operand meets that one,
/// and be no edge of the solid. Else it is an edge of one of the two if the line is, or they
/// intersect.
std::optional<Edge> bend_of(const Canonical& c, const SightLine& line, Index right, Index left) {
  const Index one = c.faces[right].body, other = c.faces[left].body;
  const Index first = wins_tie(c, right, left) ? one : other;
  const bool cut = c.faces[right].cut || c.faces[left].cut;
  if (const WingedEdge* edge = shared_edge(c, right, left)) {
    if (!edge->crease) return std::nullopt;
    return Edge{cut ? StrokeKind::cut_outline : StrokeKind::crease, first};
  }
  const bool facets = line.lies_in(c.faces[right].plane) && line.lies_in(c.faces[left].plane);
  if (line.smooth && facets) return std::nullopt;
  if (!line.smooth && (line.body == one || line.body == other)) return Edge{line.kind, line.body};
  return Edge{cut ? StrokeKind::cut_outline : StrokeKind::intersection, first};
}

std::optional<Edge> edge_at(const Canonical& c, const SightLine& line, const Beside& right,
                            const Beside& left) {
  if (right.face != kNone && left.face != kNone) {
    if (c.faces[right.face].plane == c.faces[left.face].plane) return std::nullopt;
    return bend_of(c, line, right.face, left.face);
  }
  if (right.face == left.face) return std::nullopt;
  if (line.smooth && (right.hidden || left.hidden)) return std::nullopt;
  const CanonicalFace& seen = c.faces[right.face != kNone ? right.face : left.face];
  const bool cut = line.kind == StrokeKind::cut_outline || seen.cut;
  return Edge{cut ? StrokeKind::cut_outline : StrokeKind::contour, seen.body};
}

std::vector<SurfacePart> edges_of(const Canonical& canonical, const Surface& surface,
                                  const SightLine& line, double sliver) {
  std::vector<SurfacePart> result;
  surface.along(sliver, [&](const Interval& over, const Beside& right, const Beside& left) {
    const std::optional<Edge> edge = edge_at(canonical, line, right, left);
    if (!edge) return;
    const bool goes_on = !result.empty() && result.back().kind == edge->kind &&
                         result.back().body == edge->body &&
                         result.back().over.second == over.first;
    if (goes_on)
      result.back().over.second = over.second;
    else
      result.push_back({over, edge->kind, edge->body});
  });
  return result;
}

}  // namespace

std::vector<SurfacePart> parts_on_surfaces(const Canonical& canonical, const SightLine& line,
                                           const std::vector<SolidSight::Part>& shown,
                                           double sliver) {
  const auto [one, other] = line.solids;
  if (one != kNone && one == other)
    return edges_of(canonical, {canonical, shown, one}, line, sliver);
  Intervals there{kEverywhere};
  for (const Index solid : line.solids)
    if (solid != kNone) there = common(there, Surface(canonical, shown, solid).there(line));
  std::vector<SurfacePart> result;
  for (const Interval& over : there) result.push_back({over, line.kind, line.body});
  return result;
}

}  // namespace overstrike
