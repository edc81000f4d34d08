#include "core/visibility/shadows.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/visibility/depth.h"
#include "core/visibility/light_grid.h"

namespace overstrike {
namespace {

using Polygon3 = std::vector<Vec3>;
using Polygon2 = std::vector<Vec2>;

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// The plane of a receiver as the light sees it.
struct Receiver {
  Index face;      ///< in seen.faces; seen.faces.size() for the ground
  Index plane_id;  ///< kNone for the ground
  Plane plane;
  double along_light;  ///< dot(plane.normal, L), not 0; its sign is the lit side's
  std::vector<Vec2>
      outline;     ///< in the light's view, counter-clockwise; only when convex and of one loop
  Vec2 low, high;  ///< bounds in the light's view
  double lowest;   ///< least height towards the light
};

bool before(const Vec2& a, const Vec2& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }
bool before(const Vec3& a, const Vec3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// Keeps the part of a closed polygon where the heights given for its corners are not negative.
/// Points on an edge come from its ends in a canonical order, so that two polygons that share the
/// edge share the point to the bit.
template <class Point>
std::vector<Point> cut(const std::vector<Point>& polygon, const std::vector<double>& heights) {
  std::vector<Point> result;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t p = i, q = i + 1 == n ? 0 : i + 1;
    if (heights[p] >= 0) result.push_back(polygon[p]);
    if (!((heights[p] < 0 && heights[q] > 0) || (heights[p] > 0 && heights[q] < 0))) continue;
    if (before(polygon[q], polygon[p])) std::swap(p, q);
    result.push_back(polygon[p] +
                     (polygon[q] - polygon[p]) * (heights[p] / (heights[p] - heights[q])));
  }
  return result;
}

template <class Height>
Polygon2 cut_by(const Polygon2& polygon, const Height& height) {
  std::vector<double> heights;
  heights.reserve(polygon.size());
  for (const Vec2& p : polygon) heights.push_back(height(p));
  return cut(polygon, heights);
}

/// A piece of boundary in the light's view.
struct FlatShadowEdge {
  Vec2 a, b;
  int winding;
};

class Caster {
 public:
  Caster(const Canonical& whole, const Canonical& seen, const View& view)
      : whole_(whole), seen_(seen), view_(view), frame_(*whole.light), grid_(whole, frame_) {
    index_planes_of_vertices();
  }

  std::vector<Shadow> run() {
    std::vector<Shadow> shadows;
    for (Index f = 0; f < seen_.faces.size(); ++f)
      if (std::optional<Receiver> r = receiver_of(f)) add(shadows, *r);
    if (std::optional<Receiver> r = ground()) add(shadows, *r);
    return shadows;
  }

 private:
  void index_planes_of_vertices();
  std::optional<Receiver> receiver_of(Index face) const;
  std::optional<Receiver> ground() const;
  void add(std::vector<Shadow>& shadows, const Receiver& receiver);
  /// The polygon that caster face `g` leaves on the receiver, in the light's view.
  void cast(Index g, const Receiver& r, std::vector<FlatShadowEdge>& edges) const;
  void leave(const Receiver& r, Polygon2 polygon, std::vector<FlatShadowEdge>& edges) const;
  double height_over(const Receiver& r, Index vertex) const;
  Vec3 lifted(const Receiver& r, const Vec2& p) const;

  const Canonical& whole_;
  const Canonical& seen_;
  const View& view_;
  LightFrame frame_;
  LightGrid grid_;
  std::vector<Index> plane_start_, planes_of_vertex_;
};

void Caster::index_planes_of_vertices() {
  plane_start_.assign(whole_.vertices.size() + 1, 0);
  const auto each = [&](const auto& visit) {
    for (const CanonicalFace& f : whole_.faces)
      for (Index l = f.first_loop; l < f.end_loop; ++l)
        for (const Index v : whole_.loop(l)) visit(v, f.plane);
  };
  each([&](Index v, Index) { ++plane_start_[v + 1]; });
  for (std::size_t i = 1; i < plane_start_.size(); ++i) plane_start_[i] += plane_start_[i - 1];
  planes_of_vertex_.resize(plane_start_.back());
  std::vector<Index> at(plane_start_.begin(), plane_start_.end() - 1);
  each([&](Index v, Index plane) { planes_of_vertex_[at[v]++] = plane; });
}

/// The side of a face that both the eye and the light are on, or 0.
int lit_and_seen_side(const Canonical& c, const CanonicalFace& f, const View& view) {
  const int eye = side_of_eye(c.planes[f.plane], f.flipped, view.eye);
  const int light = side_of_direction(c.planes[f.plane], f.flipped, *c.light);
  if (eye == 0 || eye != light) return 0;
  return eye > 0 || !c.bodies[f.body].closed ? eye : 0;
}

std::optional<Receiver> Caster::receiver_of(Index face) const {
  const CanonicalFace& f = seen_.faces[face];
  if (f.cut || lit_and_seen_side(seen_, f, view_) == 0) return std::nullopt;
  Receiver r{face, f.plane, seen_.planes[f.plane], 0, {}, Vec2(1e300), Vec2(-1e300), 1e300};
  r.along_light = glm::dot(r.plane.normal, frame_.light);
  if (r.along_light == 0) return std::nullopt;
  for (Index l = f.first_loop; l < f.end_loop; ++l)
    for (const Index v : seen_.loop(l)) {
      const Vec3 p = frame_(seen_.vertices[v]);
      r.low = glm::min(r.low, Vec2(p)), r.high = glm::max(r.high, Vec2(p));
      r.lowest = std::min(r.lowest, p.z);
    }
  if (f.end_loop - f.first_loop == 1) r.outline = frame_.convex_outline(seen_, f);
  return r;
}

std::optional<Receiver> Caster::ground() const {
  if (!seen_.ground_z) return std::nullopt;
  const double z = *seen_.ground_z;
  if (!(frame_.light.z > 0) || !(view_.eye.z - z * view_.eye.w > 0)) return std::nullopt;
  const Vec2 all_low(-1e300), all_high(1e300);
  return Receiver{static_cast<Index>(seen_.faces.size()),
                  kNone,
                  Plane{Vec3(0, 0, 1), z},
                  frame_.light.z,
                  {},
                  all_low,
                  all_high,
                  -1e300};
}

double Caster::height_over(const Receiver& r, Index vertex) const {
  if (r.plane_id != kNone)
    for (Index i = plane_start_[vertex]; i < plane_start_[vertex + 1]; ++i)
      if (planes_of_vertex_[i] == r.plane_id) return 0;
  const Vec3& p = whole_.vertices[vertex];
  const int side = side_of_point(r.plane, p) * (r.along_light > 0 ? 1 : -1);
  const double distance = std::fabs(glm::dot(r.plane.normal, p) - r.plane.offset);
  // The sign is exact; the size only places a cut.
  return side == 0 ? 0 : side * std::max(distance, 1e-300);
}

/// Strictly: a polygon that only touches the outline of the receiver from outside leaves no shadow
/// on it.
bool separate(const Receiver& r, const Polygon2& polygon) {
  for (std::size_t i = 0; i < r.outline.size(); ++i) {
    const Vec2& a = r.outline[i];
    const Vec2 along = r.outline[(i + 1) % r.outline.size()] - a;
    if (std::all_of(polygon.begin(), polygon.end(),
                    [&](const Vec2& p) { return cross(along, p - a) <= 0; }))
      return true;
  }
  return false;
}

void Caster::cast(Index g, const Receiver& r, std::vector<FlatShadowEdge>& edges) const {
  const CanonicalFace& f = whole_.faces[g];
  if (f.plane == r.plane_id) return;
  const bool turn = side_of_direction(whole_.planes[f.plane], f.flipped, frame_.light) < 0;
  for (Index l = f.first_loop; l < f.end_loop; ++l) {
    Polygon3 loop;
    std::vector<double> heights;
    bool above = false, below = false;
    for (const Index v : whole_.loop(l)) {
      loop.push_back(whole_.vertices[v]);
      heights.push_back(height_over(r, v));
      above |= heights.back() > 0, below |= heights.back() < 0;
    }
    if (!above) continue;
    if (below) loop = cut(loop, heights);
    Polygon2 polygon;
    for (const Vec3& p : loop) polygon.emplace_back(frame_(p));
    if (turn) std::reverse(polygon.begin(), polygon.end());
    if (!separate(r, polygon)) leave(r, std::move(polygon), edges);
  }
}

Vec3 Caster::lifted(const Receiver& r, const Vec2& p) const {
  const Vec3 q = frame_.right * p.x + frame_.up * p.y;
  return q + frame_.light * ((r.plane.offset - glm::dot(r.plane.normal, q)) / r.along_light);
}

/// Keeps what lies over the receiver, and far enough from the eye to be projected. Both cuts are
/// made well outside of what is seen, so that the borders they close polygons with lie nowhere near
/// the receiver's own edges.
void Caster::leave(const Receiver& r, Polygon2 polygon, std::vector<FlatShadowEdge>& edges) const {
  if (r.plane_id != kNone) {
    const Vec2 margin = (r.high - r.low) * 0.125;
    const Vec2 low = r.low - margin, high = r.high + margin;
    polygon = cut_by(polygon, [&](const Vec2& p) { return p.x - low.x; });
    polygon = cut_by(polygon, [&](const Vec2& p) { return high.x - p.x; });
    polygon = cut_by(polygon, [&](const Vec2& p) { return p.y - low.y; });
    polygon = cut_by(polygon, [&](const Vec2& p) { return high.y - p.y; });
  }
  if (view_.perspective) {
    const Plane& near = *view_.near_plane;
    const double at_eye = glm::dot(near.normal, Vec3(view_.eye));
    const double half_way = (near.offset + at_eye) / 2;
    polygon = cut_by(polygon,
                     [&](const Vec2& p) { return glm::dot(near.normal, lifted(r, p)) - half_way; });
  }
  for (std::size_t i = 0; polygon.size() > 2 && i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    if (a != b) edges.push_back({a, b, 1});
  }
}

/// Borders between two casters are there twice, once in each direction: they cancel.
void cancel(std::vector<FlatShadowEdge>& edges) {
  for (FlatShadowEdge& e : edges)
    if (before(e.b, e.a)) std::swap(e.a, e.b), e.winding = -e.winding;
  const auto ends = [](const FlatShadowEdge& e) { return std::tie(e.a.x, e.a.y, e.b.x, e.b.y); };
  std::sort(edges.begin(), edges.end(),
            [&](const auto& p, const auto& q) { return ends(p) < ends(q); });
  std::size_t out = 0;
  for (std::size_t i = 0; i < edges.size();) {
    FlatShadowEdge sum = edges[i];
    std::size_t j = i + 1;
    while (j < edges.size() && ends(edges[j]) == ends(sum)) sum.winding += edges[j++].winding;
    if (sum.winding != 0) edges[out++] = sum;
    i = j;
  }
  edges.resize(out);
}

/// A line that has the whole outline on one side, or an edge of the outline that has the whole line
/// outside.
bool misses(const Receiver& r, const FlatShadowEdge& e) {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < r.outline.size(); ++i) {
    const Vec2& a = r.outline[i];
    const Vec2 along = r.outline[(i + 1) % r.outline.size()] - a;
    if (cross(along, e.a - a) <= 0 && cross(along, e.b - a) <= 0) return true;
    const double side = cross(e.b - e.a, a - e.a);
    left += side >= 0, right += side <= 0;
  }
  const int all = static_cast<int>(r.outline.size());
  return left == all || right == all;
}

/// When no boundary passes over the inside of a convex receiver it is in shadow all over or not at
/// all.
bool uniform(const Receiver& r, const std::vector<FlatShadowEdge>& edges) {
  return !r.outline.empty() && std::all_of(edges.begin(), edges.end(),
                                           [&](const FlatShadowEdge& e) { return misses(r, e); });
}

int winding_at(const Vec2& p, const std::vector<FlatShadowEdge>& edges) {
  int winding = 0;
  for (const FlatShadowEdge& e : edges) {
    if ((e.a.y <= p.y) == (e.b.y <= p.y)) continue;
    const bool left = cross(e.b - e.a, p - e.a) > 0;
    if (e.b.y > e.a.y && left) winding += e.winding;
    if (e.b.y < e.a.y && !left) winding -= e.winding;
  }
  return winding;
}

void Caster::add(std::vector<Shadow>& shadows, const Receiver& r) {
  std::vector<FlatShadowEdge> edges;
  grid_.over(r.low, r.high, r.lowest, [&](Index g) { cast(g, r, edges); });
  cancel(edges);
  if (edges.empty()) return;
  Shadow shadow{r.face, false, {}};
  if (uniform(r, edges)) {
    Vec2 middle(0);
    for (const Vec2& p : r.outline) middle += p / static_cast<double>(r.outline.size());
    if (winding_at(middle, edges) == 0) return;
    shadow.covered = true;
  } else {
    for (const FlatShadowEdge& e : edges)
      shadow.edges.push_back({lifted(r, e.a), lifted(r, e.b), e.winding});
  }
  shadows.push_back(std::move(shadow));
}

}  // namespace

std::vector<Shadow> cast_shadows(const Canonical& whole, const Canonical& seen, const View& view) {
  if (!whole.light) return {};
  return Caster(whole, seen, view).run();
}

}  // namespace overstrike
