#include "core/visibility/edge_resolver.h"

#include <algorithm>
#include <cmath>

namespace overstrike {
namespace {

/// A crossing is where the line meets another that was projected with errors like its own; each end
/// of an interval is off by both, divided by the sine of the angle between them. Below 1/8 of a
/// radian the crossing is decided by corners, which are exact by topology.
constexpr double kSliverErrors = 2 * 2 * 8;

}  // namespace

double sliver_of(const Ruler& ruler) { return kSliverErrors * ruler.error(); }

std::vector<VisiblePart> EdgeResolver::visible(const SightLine& line) {
  const Ruler ruler(line.a.grid, line.b.grid);
  const Interval page = on_page(line);
  if (ruler.is_point() || !(page.first < page.second)) return {};
  hidden_[0].clear(), hidden_[1].clear();
  solids_.clear(), shown_.clear();
  if (scene_.has_ground() && !line.lies_in(scene_.ground())) hide_below_ground(line);
  const double za = line.a.grid.at.z, zb = line.b.grid.at.z;
  // What reaches as near as the line is asked for: a solid's faces that lie in it say where it is
  // an edge. The errors may be 0.
  const double behind = std::nextafter(
      std::min(za, zb) - std::max(line.a.grid.depth_error, line.b.grid.depth_error), -HUGE_VAL);
  const auto covers = [&](const Intervals& intervals) {
    return !intervals.empty() && intervals.back().first <= page.first &&
           intervals.back().second >= page.second;
  };
  query_.along(line.at(page.first), line.at(page.second), ruler.error(), behind,
               [&](const FaceBox& box) {
                 hide_behind(line, ruler, box.face);
                 return !(covers(hidden_[0]) && covers(hidden_[1]));
               });
  const double sliver = sliver_of(ruler) / ruler.length();
  if (!solids_.empty()) hide_by_solids(ruler, sliver);
  unite(hidden_[0]), unite(hidden_[1]);
  const Intervals hidden = common(hidden_[0], hidden_[1]);
  std::vector<VisiblePart> result;
  for (const SurfacePart& drawn : parts_on_surfaces(scene_.canonical, line, shown_, sliver))
    for (const Interval& part : common(line.within, {drawn.over})) {
      const Interval whole{std::max(part.first, page.first), std::min(part.second, page.second)};
      for (const Interval& piece : without(whole, hidden, sliver))
        result.push_back({piece, drawn.kind, drawn.body});
    }
  return result;
}

void EdgeResolver::hide_by_solids(const Ruler& ruler, double sliver) {
  solids_.resolve(ruler, sliver, SolidSight::Ends::in_line, shown_);
  for (const SolidSight::Part& part : shown_)
    if (part.hides) hidden_[part.side].push_back(part.over);
}

Intervals EdgeResolver::inside(const SightLine& line, Index face) {
  const Passage& passage = crossings_.over(face, Ruler(line.a.grid, line.b.grid));
  return common(common(passage.side[0], passage.side[1]), {{0.0, 1.0}});
}

/// The parameters between which the line is on the page.
Interval EdgeResolver::on_page(const SightLine& line) const {
  Interval page{0, 1};
  const auto keep = [&](double a, double b) {
    const Interval part = positive_part(a, b);
    page.first = std::max(page.first, part.first);
    page.second = std::min(page.second, part.second);
  };
  const auto keep_between = [&](double a, double b, double size) {
    if (a == b && a >= 0 && a <= size) return;
    keep(a, b);
    keep(size - a, size - b);
  };
  keep_between(line.a.grid.at.x, line.b.grid.at.x, scene_.view.grid.columns);
  keep_between(line.a.grid.at.y, line.b.grid.at.y, scene_.view.grid.rows);
  return page;
}

/// How much nearer the plane is than the line's end: 0 when the end lies on it by topology, or but
/// for rounding. Rounding moves the end in depth, and across the slope of the plane; the plane
/// itself was made from points with as much rounding, hence twice.
Lead EdgeResolver::lead(const LineEnd& end, Index plane) const {
  if (end.vertex != kNone && scene_.touches(end.vertex, plane)) return {0, 0};
  const DepthPlane& d = scene_.depth(plane);
  const Vec3& p = end.grid.at;
  const double lead = d.at(p.x, p.y) - p.z;
  const double moved = end.grid.depth_error + (std::fabs(d.a) + std::fabs(d.b)) * end.grid.error;
  const double plane_error = d.ea * std::fabs(p.x) + d.eb * std::fabs(p.y) + d.ec;
  const double error = 2 * moved + plane_error;
  return {std::fabs(lead) <= error ? 0 : lead, error};
}

void EdgeResolver::hide_behind(const SightLine& line, const Ruler& ruler, Index face) {
  const CanonicalFace& f = scene_.canonical.faces[face];
  const bool operand = scene_.canonical.membership(f.body).solid != kNone;
  const bool lies_in = line.lies_in(f.plane);
  if (lies_in && !operand) return;
  const Lead at_a = lies_in ? Lead{0, 0} : lead(line.a, f.plane),
             at_b = lies_in ? Lead{0, 0} : lead(line.b, f.plane);
  if (operand) {
    const DepthPlane& d = scene_.depth(f.plane);
    return solids_.add(
        {face, {at_a, at_b}, scene_.side(face), {d.a, d.b}, crossings_.over(face, ruler)});
  }
  const Interval behind = positive_part(at_a.value, at_b.value);
  if (!(behind.first < behind.second)) return;
  const Passage& passage = crossings_.over(face, ruler);
  for (int side = 0; side < 2; ++side)
    for (const Interval& over : passage.side[side]) {
      const Interval hidden{std::max(over.first, behind.first),
                            std::min(over.second, behind.second)};
      if (hidden.first < hidden.second) hidden_[side].push_back(hidden);
    }
}

/// From above, the ground hides what lies below it, as far as the near plane leaves it.
void EdgeResolver::hide_below_ground(const SightLine& line) {
  const auto depth_below = [&](const LineEnd& end) {
    return -scene_.height(scene_.ground(), end.world);
  };
  Interval below = positive_part(depth_below(line.a), depth_below(line.b));
  if (!(below.first < below.second)) return;
  below = {line.in_grid(below.first), line.in_grid(below.second)};
  if (scene_.view.near_plane && scene_.has_depth(scene_.near_plane())) {
    const DepthPlane &near = scene_.depth(scene_.near_plane()),
                     &ground = scene_.depth(scene_.ground());
    const auto beyond = [&](const Vec3& p) { return near.at(p.x, p.y) - ground.at(p.x, p.y); };
    const Interval there = positive_part(beyond(line.a.grid.at), beyond(line.b.grid.at));
    below = {std::max(below.first, there.first), std::min(below.second, there.second)};
    if (!(below.first < below.second)) return;
  }
  hidden_[0].push_back(below), hidden_[1].push_back(below);
}

}  // namespace overstrike
