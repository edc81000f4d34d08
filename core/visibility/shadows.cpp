#include "core/visibility/shadows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "core/geometry/even_odd.h"
#include "core/visibility/caster_index.h"
#include "core/visibility/depth.h"
#include "core/visibility/light_frame.h"

namespace overstrike {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

bool before(const Vec2& a, const Vec2& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }
bool before(const Vec3& a, const Vec3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// Keeps the part of a closed polygon where the heights given for its corners are not negative.
/// Points on an edge come from its ends in a canonical order, so that two polygons that share the
/// edge share the point to the bit.
template <class Point>
void cut(const std::vector<Point>& polygon, const std::vector<double>& heights,
         std::vector<Point>& result) {
  result.clear();
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t p = i, q = i + 1 == n ? 0 : i + 1;
    if (heights[p] >= 0) result.push_back(polygon[p]);
    if (!((heights[p] < 0 && heights[q] > 0) || (heights[p] > 0 && heights[q] < 0))) continue;
    if (before(polygon[q], polygon[p])) std::swap(p, q);
    result.push_back(polygon[p] +
                     (polygon[q] - polygon[p]) * (heights[p] / (heights[p] - heights[q])));
  }
}

/// A piece of boundary across the light.
struct FlatShadowEdge {
  Vec2 a, b;
  int winding;
};

/// The plane of a receiver as the light sees it.
struct Receiver {
  Index face;      ///< in seen.faces; seen.faces.size() for the ground
  Index body;      ///< in whole.bodies; kNone for the ground
  Index plane_id;  ///< kNone for the ground
  Plane plane;
  double along_light;  ///< dot(plane.normal, L), not 0; its sign is the lit side's
  LightRegion region;  ///< across the light
  double low_z = -HUGE_VAL, high_z = -HUGE_VAL;  ///< bounds of its heights towards the light
};

/// The light's view: x and y across it, y down as in every view, depth the height towards it.
View view_of(const LightFrame& frame) {
  View view;
  const Vec3 rows[4] = {frame.right, -frame.up, Vec3(0.0), frame.light};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 3; ++column) view.matrix[column][row] = rows[row][column];
  view.matrix[3] = Vec4(0, 0, 1, 0);
  view.eye = Vec4(frame.light, 0);
  return view;
}

/// The side of a face that both the eye and the light are on, or 0.
int lit_and_seen_side(const Canonical& c, const CanonicalFace& f, const View& view) {
  const int eye = side_of_eye(c.planes[f.plane], f.flipped, view.eye);
  const int light = side_of_direction(c.planes[f.plane], f.flipped, *c.light);
  if (eye == 0 || eye != light) return 0;
  return eye > 0 || !c.bodies[f.body].closed ? eye : 0;
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

}  // namespace

struct ShadowCaster::Scratch::Impl {
  RegionGrid::Stamps bodies, faces;
  std::vector<FlatShadowEdge> edges;
  std::vector<Vec2> outline;  ///< of the receiver, counter-clockwise; only when strictly convex
  bool outline_known = false;
  std::vector<Vec3> loop, loop_cut;
  std::vector<Vec2> polygon, polygon_cut;
  std::vector<double> heights;
};

ShadowCaster::Scratch::Scratch() : impl_(std::make_unique<Impl>()) {}
ShadowCaster::Scratch::~Scratch() = default;
ShadowCaster::Scratch::Scratch(Scratch&&) noexcept = default;

struct ShadowCaster::Impl {
  using Work = Scratch::Impl;

  Impl(const Canonical& whole_input, const Canonical& seen_input, const View& in_view, int threads)
      : whole(whole_input),
        seen(seen_input),
        view(in_view),
        frame(*whole.light),
        light(whole, view_of(frame), FrontUse::outlines, threads),
        index(light) {
    if (&whole == &seen) return;
    std::map<Index, Index> by_source;
    for (Index b = 0; b < whole.bodies.size(); ++b) by_source[whole.bodies[b].source] = b;
    for (const CanonicalBody& body : seen.bodies) whole_body.push_back(by_source.at(body.source));
  }

  std::optional<Receiver> receiver_of(Index face) const;
  std::optional<Receiver> ground() const;
  Shadow cast_on(const Receiver& receiver, Work& work) const;
  bool cast_body(Index body, const Receiver& r, Work& work) const;
  bool leave_outline(const FrontBody& body, const Receiver& r, Work& work) const;
  void leave_faces(Index body, const Receiver& r, Work& work) const;
  void leave_face(Index face, bool crossed, const Receiver& r, Work& work) const;
  void leave(const Receiver& r, Work& work) const;
  const std::vector<Vec2>& outline_of(const Receiver& r, Work& work) const;
  double height_over(const Receiver& r, Index body, Index vertex) const;
  Vec3 lifted(const Receiver& r, const Vec2& p) const;
  bool walked(const FrontBody& body) const { return !body.loose && !body.broken; }

  const Canonical& whole;
  const Canonical& seen;
  const View& view;
  const LightFrame frame;
  const FrontTable light;
  const CasterIndex index;
  std::vector<Index> whole_body;  ///< per body of `seen`; empty when they are the same
};

std::optional<Receiver> ShadowCaster::Impl::receiver_of(Index face) const {
  if (face == seen.faces.size()) return ground();
  const CanonicalFace& f = seen.faces[face];
  if (f.cut || lit_and_seen_side(seen, f, view) == 0) return std::nullopt;
  Receiver r{};
  r.face = face;
  r.body = whole_body.empty() ? f.body : whole_body[f.body];
  r.plane_id = f.plane;
  r.plane = seen.planes[f.plane];
  r.along_light = glm::dot(r.plane.normal, frame.light);
  if (r.along_light == 0) return std::nullopt;
  double low = HUGE_VAL, high = -HUGE_VAL, size = 0;
  for (Index l = f.first_loop; l < f.end_loop; ++l)
    for (const Index v : seen.loop(l)) {
      const Vec3& p = seen.vertices[v];
      const Vec3 q = frame(p);
      r.region.add(Vec2(q));
      low = std::min(low, q.z), high = std::max(high, q.z);
      size = std::max(size, glm::dot(glm::abs(frame.light), glm::abs(p)));
    }
  // A sum of three products.
  constexpr double kError = 4 * 0x1p-52;
  r.low_z = low - kError * size, r.high_z = high + kError * size;
  return r;
}

std::optional<Receiver> ShadowCaster::Impl::ground() const {
  if (!seen.ground_z) return std::nullopt;
  const double z = *seen.ground_z;
  if (!(frame.light.z > 0) || !(view.eye.z - z * view.eye.w > 0)) return std::nullopt;
  Receiver r{};
  r.face = static_cast<Index>(seen.faces.size());
  r.body = r.plane_id = kNone;
  r.plane = Plane{Vec3(0, 0, 1), z};
  r.along_light = frame.light.z;
  r.region = {Vec2(-HUGE_VAL), Vec2(HUGE_VAL)};
  return r;
}

double ShadowCaster::Impl::height_over(const Receiver& r, Index body, Index vertex) const {
  const Vec3& p = whole.vertices[vertex];
  const double height = glm::dot(r.plane.normal, p) - r.plane.offset;
  // What belongs to the plane is no farther from it than welding lets it be.
  constexpr double kNear = 0x1p-16;
  const double size = glm::dot(glm::abs(r.plane.normal), glm::abs(p)) + std::fabs(r.plane.offset);
  const bool lit_above = r.along_light > 0;
  if (std::fabs(height) > kNear * size) return lit_above ? height : -height;
  if (r.plane_id != kNone && index.touches(body, vertex, r.plane_id)) return 0;
  const double exact = height_of_point(r.plane, p);
  return lit_above ? exact : -exact;
}

/// Strictly: a polygon that only touches the outline of the receiver from outside leaves no shadow
/// on it.
bool separate(const std::vector<Vec2>& outline, const std::vector<Vec2>& polygon) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& a = outline[i];
    const Vec2 along = outline[i + 1 == outline.size() ? 0 : i + 1] - a;
    if (std::all_of(polygon.begin(), polygon.end(),
                    [&](const Vec2& p) { return cross(along, p - a) <= 0; }))
      return true;
  }
  return false;
}

/// A line that has the whole outline on one side, or an edge of the outline that has the whole line
/// outside.
bool misses(const std::vector<Vec2>& outline, const FlatShadowEdge& e) {
  std::size_t left = 0, right = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& a = outline[i];
    const Vec2 along = outline[i + 1 == outline.size() ? 0 : i + 1] - a;
    if (cross(along, e.a - a) <= 0 && cross(along, e.b - a) <= 0) return true;
    const double side = cross(e.b - e.a, a - e.a);
    left += side >= 0, right += side <= 0;
  }
  return left == outline.size() || right == outline.size();
}

/// True when the receiver is covered.
bool ShadowCaster::Impl::cast_body(Index number, const Receiver& r, Work& work) const {
  const FrontBody& body = light.bodies[number];
  if (!body.seen || body.near_z <= r.low_z) return false;
  if (!walked(body)) return leave_faces(number, r, work), false;
  if (number == r.body) return false;
  const bool above = r.body == kNone ? body.low.z >= r.plane.offset : body.far_z >= r.high_z;
  if (above) return leave_outline(body, r, work);
  leave_faces(number, r, work);
  return false;
}

/// The sides of the outline between the receiver's levels, down on the left and up on the right.
/// (The table's y points down, the receiver's up.)
bool ShadowCaster::Impl::leave_outline(const FrontBody& body, const Receiver& r, Work& work) const {
  const double top = -r.region.high.y, bottom = -r.region.low.y;
  if (bottom <= body.top || top >= body.bottom) return false;
  struct Chain {
    const OutlineSide *first, *end;
    double least = HUGE_VAL, most = -HUGE_VAL;
  };
  const auto chain = [&](Index first, Index end) {
    const OutlineSide* const sides = light.outlines.data();
    Chain c{std::partition_point(sides + first, sides + end,
                                 [&](const OutlineSide& s) { return s.line.y1 <= top; }),
            sides + end};
    const OutlineSide* i = c.first;
    for (; i != c.end && i->line.y0 < bottom; ++i) {
      for (const double y : {std::max(i->line.y0, top), std::min(i->line.y1, bottom)}) {
        const double x = y == i->line.y1 ? i->x1 : i->line.x_at(y);
        c.least = std::min(c.least, x), c.most = std::max(c.most, x);
      }
    }
    c.end = i;
    return c;
  };
  const Chain left = chain(body.first_left, body.end_left);
  const Chain right = chain(body.first_right, body.end_right);
  if (left.least >= r.region.high.x || right.most <= r.region.low.x) return false;
  if (left.most <= r.region.low.x && right.least >= r.region.high.x && body.top <= top &&
      body.bottom >= bottom)
    return true;
  std::vector<Vec2>& polygon = work.polygon;
  polygon.clear();
  const auto add = [&](double x, double y) {
    const Vec2 p(x, -y);
    if (polygon.empty() || polygon.back() != p) polygon.push_back(p);
  };
  for (const OutlineSide* s = left.first; s != left.end; ++s)
    add(s->line.x0, s->line.y0), add(s->x1, s->line.y1);
  for (const OutlineSide* s = right.end; s != right.first;) {
    --s;
    add(s->x1, s->line.y1), add(s->line.x0, s->line.y0);
  }
  leave(r, work);
  return false;
}

void ShadowCaster::Impl::leave_faces(Index body, const Receiver& r, Work& work) const {
  const std::vector<Index>& faces = index.faces_of(body);
  const std::vector<char>& crossed = index.crossed(body);
  const auto visit = [&](Index i) { leave_face(faces[i], crossed[i] != 0, r, work); };
  if (r.body == kNone) {
    for (Index i = 0; i < faces.size(); ++i) visit(i);
    return;
  }
  const LightRegion region{Vec2(r.region.low.x, -r.region.high.y),
                           Vec2(r.region.high.x, -r.region.low.y)};
  index.grid_of(body).over(region, work.faces, visit);
}

void ShadowCaster::Impl::leave_face(Index g, bool crossed, const Receiver& r, Work& work) const {
  const CanonicalFace& f = whole.faces[g];
  if (f.plane == r.plane_id) return;
  const bool turn = light.from_behind(g);
  std::vector<std::vector<Vec2>> loops;
  for (Index l = f.first_loop; l < f.end_loop; ++l) {
    work.loop.clear(), work.heights.clear();
    bool above = false, below = false;
    for (const Index v : whole.loop(l)) {
      work.loop.push_back(whole.vertices[v]);
      work.heights.push_back(height_over(r, f.body, v));
      above |= work.heights.back() > 0, below |= work.heights.back() < 0;
    }
    if (!above) continue;
    if (below) {
      cut(work.loop, work.heights, work.loop_cut);
      work.loop.swap(work.loop_cut);
    }
    work.polygon.clear();
    for (const Vec3& p : work.loop) work.polygon.emplace_back(frame(p));
    if (crossed) {
      loops.push_back(work.polygon);
      continue;
    }
    if (turn) std::reverse(work.polygon.begin(), work.polygon.end());
    if (!separate(outline_of(r, work), work.polygon)) leave(r, work);
  }
  if (!crossed) return;
  for (const Trapezoid& part : even_odd(loops).parts) {
    work.polygon.assign(part.begin(), part.end());
    leave(r, work);
  }
}

const std::vector<Vec2>& ShadowCaster::Impl::outline_of(const Receiver& r, Work& work) const {
  if (work.outline_known || r.body == kNone) return work.outline;
  const CanonicalFace& f = seen.faces[r.face];
  if (f.end_loop - f.first_loop == 1) frame.convex_outline(seen, f, work.outline);
  work.outline_known = true;
  return work.outline;
}

Vec3 ShadowCaster::Impl::lifted(const Receiver& r, const Vec2& p) const {
  const Vec3 q = frame.right * p.x + frame.up * p.y;
  return q + frame.light * ((r.plane.offset - glm::dot(r.plane.normal, q)) / r.along_light);
}

/// Keeps what lies over the receiver, and far enough from the eye to be projected. Both cuts are
/// made well outside of what is seen, so that the borders they close polygons with lie nowhere near
/// the receiver's own edges.
void ShadowCaster::Impl::leave(const Receiver& r, Work& work) const {
  std::vector<Vec2>& polygon = work.polygon;
  const auto keep = [&](const auto& height) {
    work.heights.clear();
    bool beyond = false;
    for (const Vec2& p : polygon) {
      work.heights.push_back(height(p));
      beyond |= work.heights.back() < 0;
    }
    if (!beyond) return;
    cut(polygon, work.heights, work.polygon_cut);
    polygon.swap(work.polygon_cut);
  };
  if (r.body != kNone) {
    const Vec2 margin = (r.region.high - r.region.low) * 0.125;
    const Vec2 low = r.region.low - margin, high = r.region.high + margin;
    keep([&](const Vec2& p) { return p.x - low.x; });
    keep([&](const Vec2& p) { return high.x - p.x; });
    keep([&](const Vec2& p) { return p.y - low.y; });
    keep([&](const Vec2& p) { return high.y - p.y; });
  }
  if (view.perspective) {
    const Plane& near = *view.near_plane;
    const double at_eye = glm::dot(near.normal, Vec3(view.eye));
    const double half_way = (near.offset + at_eye) / 2;
    keep([&](const Vec2& p) { return glm::dot(near.normal, lifted(r, p)) - half_way; });
  }
  for (std::size_t i = 0; polygon.size() > 2 && i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    if (a != b) work.edges.push_back({a, b, 1});
  }
}

Shadow ShadowCaster::Impl::cast_on(const Receiver& r, Work& work) const {
  Shadow shadow{r.face, false, {}};
  work.edges.clear(), work.outline.clear();
  work.outline_known = false;
  const LightRegion region{Vec2(r.region.low.x, -r.region.high.y),
                           Vec2(r.region.high.x, -r.region.low.y)};
  bool covered = false;
  if (r.body == kNone) {
    for (Index b = 0; b < whole.bodies.size(); ++b) cast_body(b, r, work);
  } else {
    index.bodies().over(region, work.bodies,
                        [&](Index b) { covered = covered || cast_body(b, r, work); });
  }
  if (covered) {
    shadow.covered = true;
    return shadow;
  }
  cancel(work.edges);
  if (work.edges.empty()) return shadow;
  // When no boundary passes over the inside of a convex receiver it is in shadow all over or not at
  // all.
  const std::vector<Vec2>& outline = outline_of(r, work);
  const bool uniform =
      !outline.empty() && std::all_of(work.edges.begin(), work.edges.end(),
                                      [&](const auto& e) { return misses(outline, e); });
  if (uniform) {
    Vec2 middle(0);
    for (const Vec2& p : outline) middle += p / static_cast<double>(outline.size());
    shadow.covered = winding_at(middle, work.edges) != 0;
    return shadow;
  }
  shadow.edges.reserve(work.edges.size());
  for (const FlatShadowEdge& e : work.edges)
    shadow.edges.push_back({lifted(r, e.a), lifted(r, e.b), e.winding});
  return shadow;
}

ShadowCaster::ShadowCaster(const Canonical& whole, const Canonical& seen, const View& view,
                           int threads)
    : impl_(whole.light ? std::make_unique<const Impl>(whole, seen, view, threads) : nullptr) {}
ShadowCaster::~ShadowCaster() = default;

bool ShadowCaster::receives(Index receiver) const {
  return impl_ != nullptr && impl_->receiver_of(receiver).has_value();
}

Shadow ShadowCaster::on(Index receiver, Scratch& scratch) const {
  if (impl_ != nullptr)
    if (const std::optional<Receiver> r = impl_->receiver_of(receiver))
      return impl_->cast_on(*r, *scratch.impl_);
  return {receiver, false, {}};
}

std::vector<Shadow> ShadowCaster::all() const {
  std::vector<Shadow> shadows;
  if (impl_ == nullptr) return shadows;
  Scratch scratch;
  for (Index f = 0; f <= impl_->seen.faces.size(); ++f) {
    Shadow shadow = on(f, scratch);
    if (shadow.covered || !shadow.edges.empty()) shadows.push_back(std::move(shadow));
  }
  return shadows;
}

std::vector<Shadow> cast_shadows(const Canonical& whole, const Canonical& seen, const View& view) {
  return ShadowCaster(whole, seen, view, 1).all();
}

}  // namespace overstrike
