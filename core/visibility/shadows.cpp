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
#include "core/visibility/plane_gap.h"
#include "core/visibility/shadow_border.h"

namespace overstrike {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// What a plane may be off its vertices, in parts of their coordinates: vertices are rounded three
/// times over (shaped, placed, counted from the origin), and the offset is a rounded sum of rounded
/// products, a normal's and a vertex's. Where it is farther off, the file's own rounding has bent
/// the face, or welding has moved it.
constexpr double kPlaneRounding = 16 * 0x1p-53;

/// The plane of a receiver as the light sees it. A receiver is what the eye sees of it: its corners
/// are where the eye sees its vertices on the plane.
struct Receiver {
  Index face;      ///< in seen.faces; seen.faces.size() for the ground
  Index body;      ///< in whole.bodies; kNone for the ground
  Index plane_id;  ///< kNone for the ground
  Plane plane;
  bool off_plane;      ///< its vertices lie farther off it than rounding alone takes them
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

}  // namespace

struct ShadowCaster::Scratch::Impl {
  RegionGrid::Stamps bodies, faces;
  std::vector<ShadowBorder> edges;
  std::vector<Vec2> outline;  ///< of the receiver, counter-clockwise; only when strictly convex
  bool outline_known = false;
  std::vector<Vec2> corners;
  ShadowPolygon polygon, polygon_cut;
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

  template <class Visit>
  void for_each_vertex(const CanonicalFace& f, const Visit& visit) const {
    // The corners of a face's loops follow each other.
    for (Index i = seen.first_corner(f.first_loop); i < seen.first_corner(f.end_loop); ++i)
      visit(seen.vertices[seen.corners[i]]);
  }
  std::optional<Receiver> receiver_of(Index face) const;
  Vec3 seen_on(const Plane& plane, const Vec3& p) const;
  std::optional<Receiver> ground() const;
  Shadow cast_on(const Receiver& receiver, Work& work) const;
  bool cast_body(Index body, const Receiver& r, Work& work) const;
  bool leave_outline(const FrontBody& body, const Receiver& r, Work& work) const;
  void leave_faces(Index body, const Receiver& r, Work& work) const;
  void leave_face(Index face, const Receiver& r, Work& work) const;
  void leave_crossed(Index face, const Receiver& r, Work& work) const;
  bool take_above(Index loop, const PlaneGap& gap, Work& work) const;
  void leave(const Receiver& r, int winding, Work& work) const;
  const std::vector<Vec2>& outline_of(const Receiver& r, Work& work) const;
  Vec3 lifted(const Receiver& r, const Vec2& p) const;
  bool walked(const FrontBody& body) const { return !body.loose && !body.broken && !body.turned; }
  bool is_above_ground(Index body, const Plane& ground) const;

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
  r.along_light = along(r.plane, frame.light);
  double size = 0, off = 0, low = HUGE_VAL, high = -HUGE_VAL;
  const auto add = [&](const Vec3& q) {
    r.region.add(Vec2(q));
    low = std::min(low, q.z), high = std::max(high, q.z);
  };
  for_each_vertex(f, [&](const Vec3& p) {
    off = std::max(off, std::fabs(glm::dot(r.plane.normal, p) - r.plane.offset));
    size = std::max(size, std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z));
    add(frame(p));
  });
  size += std::fabs(r.plane.offset);
  r.off_plane = off > kPlaneRounding * size;
  if (r.off_plane) {
    r.region = {}, low = HUGE_VAL, high = -HUGE_VAL;
    for_each_vertex(f, [&](const Vec3& p) { add(frame(seen_on(r.plane, p))); });
  }
  // The plane passes its vertices by at `off` / |n . L|. What was rounded: two sums of products of
  // at most `size` and twice that, and n . L, whose part of itself is as much of the quotient.
  constexpr double kError = 4 * 0x1p-52;
  const double steep = 1 / std::fabs(r.along_light);
  const double error = kError * size + steep * (off + kError * (2 * size + steep * off));
  r.low_z = low - 2 * error, r.high_z = high + 2 * error;
  return r;
}

/// Where the eye sees a vertex on a plane.
Vec3 ShadowCaster::Impl::seen_on(const Plane& plane, const Vec3& p) const {
  const Vec3 to_eye = Vec3(view.eye) - p * view.eye.w;
  const double facing = glm::dot(plane.normal, to_eye);
  return facing == 0 ? p : p - to_eye * (height_of_point(plane, p) / facing);
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

/// Strictly: a polygon that only touches the outline of the receiver from outside leaves no shadow
/// on it.
bool separate(const std::vector<Vec2>& outline, const ShadowPolygon& polygon) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& a = outline[i];
    const Vec2 along = outline[i + 1 == outline.size() ? 0 : i + 1] - a;
    if (std::all_of(polygon.begin(), polygon.end(),
                    [&](const SidePart& p) { return cross(along, p.from() - a) <= 0; }))
      return true;
  }
  return false;
}

/// A line that has the whole outline on one side, or an edge of the outline that has the whole line
/// outside.
bool misses(const std::vector<Vec2>& outline, const ShadowBorder& border) {
  const Vec2 from = border.part.from(), to = border.part.to();
  std::size_t left = 0, right = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& a = outline[i];
    const Vec2 along = outline[i + 1 == outline.size() ? 0 : i + 1] - a;
    if (cross(along, from - a) <= 0 && cross(along, to - a) <= 0) return true;
    const double side = cross(to - from, a - from);
    left += side >= 0, right += side <= 0;
  }
  return left == outline.size() || right == outline.size();
}

/// True when the receiver is covered.
bool ShadowCaster::Impl::cast_body(Index number, const Receiver& r, Work& work) const {
  const FrontBody& body = light.bodies[number];
  if (!body.seen || body.near_z <= r.low_z) return false;
  if (!walked(body)) return leave_faces(number, r, work), false;
  if (number == r.body) {
    if (r.off_plane) leave_faces(number, r, work);
    return false;
  }
  const bool above = r.body == kNone ? is_above_ground(number, r.plane) : body.far_z >= r.high_z;
  if (above) return leave_outline(body, r, work);
  leave_faces(number, r, work);
  return false;
}

/// Bounds what the sizes of a vertex' coordinates add up to.
double reach_of(const FrontBody& body) {
  const Vec3 reach = glm::max(glm::abs(body.low), glm::abs(body.high));
  return reach.x + reach.y + reach.z;
}

/// Whether nothing of the body's seen faces would be cut off by the ground, but for what is thinner
/// than the rounding of their corners. Faces' planes may lie below their vertices, as far as they
/// are off them; not by as much as this part of the body's height, but for faces that graze the
/// light so that they cast next to nothing.
bool ShadowCaster::Impl::is_above_ground(Index number, const Plane& ground) const {
  constexpr double kFarAbove = 0x1p-10;
  const FrontBody& front = light.bodies[number];
  if (front.low.z < ground.offset) return false;
  if (front.low.z - ground.offset >= kFarAbove * (front.high.z - front.low.z)) return true;
  const double reach = reach_of(front);
  const CanonicalBody& body = whole.bodies[number];
  for (Index f = body.first_face; f < body.end_face; ++f) {
    if (!light.seen(f)) continue;
    const PlaneGap gap(whole.planes[whole.faces[f].plane], ground, frame.light, reach);
    double least = 0, most = 0;
    for (Index i = whole.first_corner(whole.faces[f].first_loop);
         i < whole.first_corner(whole.faces[f].end_loop); ++i) {
      const double at = gap.at(whole.vertices[whole.corners[i]]);
      least = std::min(least, at), most = std::max(most, at);
    }
    if (least < -kPlaneRounding * most) return false;
  }
  return true;
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
  std::vector<Vec2>& corners = work.corners;
  corners.clear();
  const auto add = [&](double x, double y) {
    const Vec2 p(x, -y);
    if (corners.empty() || corners.back() != p) corners.push_back(p);
  };
  for (const OutlineSide* s = left.first; s != left.end; ++s)
    add(s->line.x0, s->line.y0), add(s->x1, s->line.y1);
  for (const OutlineSide* s = right.end; s != right.first;) {
    --s;
    add(s->x1, s->line.y1), add(s->line.x0, s->line.y0);
  }
  assign(work.polygon, corners);
  leave(r, 1, work);
  return false;
}

void ShadowCaster::Impl::leave_faces(Index body, const Receiver& r, Work& work) const {
  const std::vector<Index>& faces = index.faces_of(body);
  const std::vector<char>& crossed = index.crossed(body);
  const auto visit = [&](Index i) {
    crossed[i] != 0 ? leave_crossed(faces[i], r, work) : leave_face(faces[i], r, work);
  };
  if (r.body == kNone) {
    for (Index i = 0; i < faces.size(); ++i) visit(i);
    return;
  }
  const LightRegion region{Vec2(r.region.low.x, -r.region.high.y),
                           Vec2(r.region.high.x, -r.region.low.y)};
  index.grid_of(body).over(region, work.faces, visit);
}

/// Sets the polygon to what of the loop lies above the receiver's plane, across the light. False
/// when nothing does.
bool ShadowCaster::Impl::take_above(Index l, const PlaneGap& gap, Work& work) const {
  const std::span<const Index> loop = whole.loop(l);
  work.heights.resize(loop.size());
  bool above = false, below = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double height = work.heights[i] = gap.at(whole.vertices[loop[i]]);
    above |= height > 0, below |= height < 0;
  }
  if (!above) return false;
  work.corners.clear();
  for (const Index v : loop) work.corners.emplace_back(frame(whole.vertices[v]));
  assign(work.polygon, work.corners);
  if (!below) return true;
  const auto crossing = [&](std::size_t i) {
    std::size_t a = i, b = i + 1 == loop.size() ? 0 : i + 1;
    if (work.polygon[i].t0 == 1) std::swap(a, b);
    return gap.crossing(whole.vertices[loop[a]], whole.vertices[loop[b]], work.heights[a],
                        work.heights[b]);
  };
  cut(work.polygon, work.heights, crossing, work.polygon_cut);
  work.polygon.swap(work.polygon_cut);
  return true;
}

void ShadowCaster::Impl::leave_face(Index g, const Receiver& r, Work& work) const {
  const CanonicalFace& f = whole.faces[g];
  if (f.plane == r.plane_id) return;
  const FrontBody& body = light.bodies[f.body];
  const PlaneGap gap(whole.planes[f.plane], r.plane, frame.light, reach_of(body));
  for (Index l = f.first_loop; l < f.end_loop; ++l) {
    if (!take_above(l, gap, work) || separate(outline_of(r, work), work.polygon)) continue;
    const bool turns_left = body.turned ? area_of(light, g) > 0 : !light.from_behind(g);
    leave(r, turns_left ? 1 : -1, work);
  }
}

/// The outlines cross: winding numbers do not say what is inside.
void ShadowCaster::Impl::leave_crossed(Index g, const Receiver& r, Work& work) const {
  const CanonicalFace& f = whole.faces[g];
  if (f.plane == r.plane_id) return;
  const PlaneGap gap(whole.planes[f.plane], r.plane, frame.light, reach_of(light.bodies[f.body]));
  std::vector<std::vector<Vec2>> loops;
  for (Index l = f.first_loop; l < f.end_loop; ++l) {
    if (!take_above(l, gap, work)) continue;
    std::vector<Vec2>& loop = loops.emplace_back();
    for (const SidePart& part : work.polygon) loop.push_back(part.from());
  }
  for (const Trapezoid& part : even_odd(loops).parts) {
    work.corners.assign(part.begin(), part.end());
    assign(work.polygon, work.corners);
    leave(r, 1, work);
  }
}

const std::vector<Vec2>& ShadowCaster::Impl::outline_of(const Receiver& r, Work& work) const {
  if (work.outline_known || r.body == kNone) return work.outline;
  const CanonicalFace& f = seen.faces[r.face];
  if (f.end_loop - f.first_loop == 1) {
    for_each_vertex(f, [&](const Vec3& p) {
      work.outline.emplace_back(frame(r.off_plane ? seen_on(r.plane, p) : p));
    });
    keep_if_convex(work.outline);
  }
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
void ShadowCaster::Impl::leave(const Receiver& r, int winding, Work& work) const {
  ShadowPolygon& polygon = work.polygon;
  const auto keep = [&](const auto& height) {
    work.heights.clear();
    bool beyond = false;
    for (const SidePart& part : polygon) {
      work.heights.push_back(height(part.from()));
      beyond |= work.heights.back() < 0;
    }
    if (!beyond) return;
    const auto crossing = [&](std::size_t i) {
      const double a = height(polygon[i].a), b = height(polygon[i].b);
      return a / (a - b);
    };
    cut(polygon, work.heights, crossing, work.polygon_cut);
    polygon.swap(work.polygon_cut);
  };
  if (r.body != kNone) {
    const Vec2 margin = (r.region.high - r.region.low) * 0.125;
    const Vec2 low = r.region.low - margin, high = r.region.high + margin;
    LightRegion bounds;
    for (const SidePart& part : polygon) bounds.add(part.from());
    if (bounds.low.x < low.x) keep([&](const Vec2& p) { return p.x - low.x; });
    if (bounds.high.x > high.x) keep([&](const Vec2& p) { return high.x - p.x; });
    if (bounds.low.y < low.y) keep([&](const Vec2& p) { return p.y - low.y; });
    if (bounds.high.y > high.y) keep([&](const Vec2& p) { return high.y - p.y; });
  }
  if (view.perspective) {
    const Plane& near = *view.near_plane;
    const double at_eye = glm::dot(near.normal, Vec3(view.eye));
    const double half_way = (near.offset + at_eye) / 2;
    keep([&](const Vec2& p) { return glm::dot(near.normal, lifted(r, p)) - half_way; });
  }
  for (SidePart part : polygon) {
    const bool along = part.t0 < part.t1;
    if (!along) std::swap(part.t0, part.t1);
    if (part.t0 < part.t1 && part.a != part.b)
      work.edges.push_back({part, along ? winding : -winding});
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
  for (const ShadowBorder& border : work.edges)
    shadow.edges.push_back(
        {lifted(r, border.part.from()), lifted(r, border.part.to()), border.winding});
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
