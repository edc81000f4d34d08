#include "core/visibility/solid_edges.h"

#include <algorithm>
#include <optional>

namespace overstrike {
namespace {

const Interval kEverywhere{-1e300, 1e300};

/// What is seen of a solid beside the line, on one side.
struct Beside {
  Index plane = kNone;  ///< in which the line lies; kNone: hidden, or farther
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
        return part.hides ? Beside{kNone, true} : Beside{canonical_.faces[part.face].plane, false};
    return {};
  }

  const Canonical& canonical_;
  std::vector<SolidSight::Part> parts_;
};

std::optional<StrokeKind> kind_of(const SightLine& line, const Beside& right, const Beside& left) {
  if (right.plane == left.plane) return std::nullopt;
  if (right.plane != kNone && left.plane != kNone) {
    const bool facets = line.lies_in(right.plane) && line.lies_in(left.plane);
    if (line.smooth && facets) return std::nullopt;
    return line.smooth ? StrokeKind::intersection : line.kind;
  }
  if (line.smooth && (right.hidden || left.hidden)) return std::nullopt;
  return line.kind == StrokeKind::cut_outline ? line.kind : StrokeKind::contour;
}

std::vector<SurfacePart> edges_of(const Surface& surface, const SightLine& line, double sliver) {
  std::vector<SurfacePart> result;
  surface.along(sliver, [&](const Interval& over, const Beside& right, const Beside& left) {
    const std::optional<StrokeKind> kind = kind_of(line, right, left);
    if (!kind) return;
    const bool goes_on =
        !result.empty() && result.back().kind == *kind && result.back().over.second == over.first;
    if (goes_on)
      result.back().over.second = over.second;
    else
      result.push_back({over, *kind});
  });
  return result;
}

}  // namespace

std::vector<SurfacePart> parts_on_surfaces(const Canonical& canonical, const SightLine& line,
                                           const std::vector<SolidSight::Part>& shown,
                                           double sliver) {
  const auto [one, other] = line.solids;
  if (one != kNone && one == other) return edges_of({canonical, shown, one}, line, sliver);
  Intervals there{kEverywhere};
  for (const Index solid : line.solids)
    if (solid != kNone) there = common(there, Surface(canonical, shown, solid).there(line));
  std::vector<SurfacePart> result;
  for (const Interval& over : there) result.push_back({over, line.kind});
  return result;
}

}  // namespace overstrike
