#include "core/visibility/shadows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "core/geometry/even_odd.h"
#include "core/visibility/caster_index.h"
#include "core/visibility/light_frame.h"
#include "core/visibility/plane_gap.h"
#include "core/visibility/plane_rounding.h"
#include "core/visibility/shadow_border.h"
#include "core/visibility/shadow_receiver.h"

namespace overstrike {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

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

}  // namespace

/// A border of an operand's face over the receiver; t0 < t1.
struct OperandBorder {
  Index solid;
  SidePart part;
  Index face;
};

struct ShadowCaster::Scratch::Impl {
  RegionGrid::Stamps bodies, faces;
  std::vector<ShadowBorder> edges;
  std::vector<Vec2> outline;  ///< of the receiver, counter-clockwise; only when strictly convex
  bool outline_known = false;
  std::vector<Vec2> corners;
  ShadowPolygon polygon, polygon_cut;
  std::vector<double> heights;
  Index operand_face = kNone;  ///< the one in hand is an operand's
  std::vector<OperandBorder> operands;
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

  std::optional<ShadowReceiver> receiver_of(Index face) const;
  Shadow cast_on(const ShadowReceiver& receiver, Work& work) const;
  bool cast_body(Index body, const ShadowReceiver& r, Work& work) const;
  bool leave_outline(const FrontBody& body, const ShadowReceiver& r, Work& work) const;
  void leave_faces(Index body, const ShadowReceiver& r, Work& work) const;
  void leave_face(Index face, const ShadowReceiver& r, Work& work) const;
  void leave_crossed(Index face, const ShadowReceiver& r, Work& work) const;
  bool take_above(Index loop, Index plane, const PlaneGap& gap, Work& work) const;
  void leave(const ShadowReceiver& r, int winding, Work& work) const;
  const std::vector<Vec2>& outline_of(const ShadowReceiver& r, Work& work) const;
  void add_operands(const ShadowReceiver& r, Work& work, Shadow& shadow) const;
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

std::optional<ShadowReceiver> ShadowCaster::Impl::receiver_of(Index face) const {
  if (face == seen.faces.size()) return ground_receiver(seen, view, frame);
  std::optional<ShadowReceiver> r = face_receiver(seen, view, frame, face);
  if (r && !whole_body.empty()) r->body = whole_body[r->body];
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
bool ShadowCaster::Impl::cast_body(Index number, const ShadowReceiver& r, Work& work) const {
  const FrontBody& body = light.bodies[number];
  if (!body.seen || body.near_z <= r.low_z) return false;
  if (whole.membership(number).solid != kNone) return leave_faces(number, r, work), false;
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
bool ShadowCaster::Impl::leave_outline(const FrontBody& body, const ShadowReceiver& r,
                                       Work& work) const {
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

void ShadowCaster::Impl::leave_faces(Index body, const ShadowReceiver& r, Work& work) const {
  const std::vector<Index>& faces = index.faces_of(body);
  const std::vector<char>& crossed = index.crossed(body);
  const bool operand = whole.membership(body).solid != kNone;
  const auto visit = [&](Index i) {
    work.operand_face = operand ? faces[i] : kNone;
    crossed[i] != 0 ? leave_crossed(faces[i], r, work) : leave_face(faces[i], r, work);
  };
  if (r.body == kNone) {
    for (Index i = 0; i < faces.size(); ++i) visit(i);
    work.operand_face = kNone;
    return;
  }
  const LightRegion region{Vec2(r.region.low.x, -r.region.high.y),
                           Vec2(r.region.high.x, -r.region.low.y)};
  index.grid_of(body).over(region, work.faces, visit);
  work.operand_face = kNone;
}

/// Sets the polygon to what of the loop lies above the receiver's plane, across the light. False
/// when nothing does.
bool ShadowCaster::Impl::take_above(Index l, Index plane, const PlaneGap& gap, Work& work) const {
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
  cut(work.polygon, work.heights, crossing, plane, work.polygon_cut);
  work.polygon.swap(work.polygon_cut);
  return true;
}

void ShadowCaster::Impl::leave_face(Index g, const ShadowReceiver& r, Work& work) const {
  const CanonicalFace& f = whole.faces[g];
  if (f.plane == r.plane_id) return;
  const FrontBody& body = light.bodies[f.body];
  const PlaneGap gap(whole.planes[f.plane], r.plane, frame.light, reach_of(body));
  for (Index l = f.first_loop; l < f.end_loop; ++l) {
    if (!take_above(l, f.plane, gap, work) || separate(outline_of(r, work), work.polygon)) continue;
    const bool turns_left = body.turned ? area_of(light, g) > 0 : !light.from_behind(g);
    leave(r, turns_left ? 1 : -1, work);
  }
}

/// The outlines cross: winding numbers do not say what is inside.
void ShadowCaster::Impl::leave_crossed(Index g, const ShadowReceiver& r, Work& work) const {
  const CanonicalFace& f = whole.faces[g];
  if (f.plane == r.plane_id) return;
  const PlaneGap gap(whole.planes[f.plane], r.plane, frame.light, reach_of(light.bodies[f.body]));
  std::vector<std::vector<Vec2>> loops;
  for (Index l = f.first_loop; l < f.end_loop; ++l) {
    if (!take_above(l, f.plane, gap, work)) continue;
    std::vector<Vec2>& loop = loops.emplace_back();
    for (const SidePart& part : work.polygon) loop.push_back(part.from());
  }
  for (const Trapezoid& part : even_odd(loops).parts) {
    work.corners.assign(part.begin(), part.end());
    assign(work.polygon, work.corners);
    leave(r, 1, work);
  }
}

const std::vector<Vec2>& ShadowCaster::Impl::outline_of(const ShadowReceiver& r, Work& work) const {
  if (work.outline_known || r.body == kNone) return work.outline;
  convex_outline_of(r, seen, view, frame, work.outline);
  work.outline_known = true;
  return work.outline;
}

/// Keeps what lies over the receiver, and far enough from the eye to be projected. Both cuts are
/// made well outside of what is seen, so that the borders they close polygons with lie nowhere near
/// the receiver's own edges.
void ShadowCaster::Impl::leave(const ShadowReceiver& r, int winding, Work& work) const {
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
    cut(polygon, work.heights, crossing, kNone, work.polygon_cut);
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
    keep([&](const Vec2& p) { return glm::dot(near.normal, lifted(r, frame, p)) - half_way; });
  }
  for (SidePart part : polygon) {
    const bool along = part.t0 < part.t1;
    if (!along) std::swap(part.t0, part.t1);
    if (!(part.t0 < part.t1 && part.a != part.b)) continue;
    if (work.operand_face == kNone) {
      work.edges.push_back({part, along ? winding : -winding});
    } else {
      const Index body = whole.faces[work.operand_face].body;
      work.operands.push_back({whole.memberships[body].solid, part, work.operand_face});
    }
  }
}

/// Sides that two faces share are one edge between them; a face that begins and ends in one does
/// neither.
void ShadowCaster::Impl::add_operands(const ShadowReceiver& r, Work& work, Shadow& shadow) const {
  std::vector<OperandBorder>& borders = work.operands;
  const auto key = [](const OperandBorder& b) {
    return std::tuple(b.solid, b.part.a.x, b.part.a.y, b.part.b.x, b.part.b.y, b.part.t0, b.part.t1,
                      b.part.plane);
  };
  std::sort(borders.begin(), borders.end(), [&](const OperandBorder& a, const OperandBorder& b) {
    const auto p = key(a), q = key(b);
    return p != q ? p < q : a.face < b.face;
  });
  std::vector<Index> faces;
  for (std::size_t i = 0, end = 0; i < borders.size(); i = end) {
    faces.clear();
    for (end = i; end < borders.size() && key(borders[end]) == key(borders[i]); ++end) {
      if (!faces.empty() && faces.back() == borders[end].face)
        faces.pop_back();
      else
        faces.push_back(borders[end].face);
    }
    const SidePart& part = borders[i].part;
    for (std::size_t f = 0; f < faces.size(); f += 2)
      shadow.operands.push_back({lifted(r, frame, part.from()),
                                 lifted(r, frame, part.to()),
                                 borders[i].solid,
                                 {faces[f], f + 1 < faces.size() ? faces[f + 1] : kNone},
                                 part.plane});
  }
}

Shadow ShadowCaster::Impl::cast_on(const ShadowReceiver& r, Work& work) const {
  Shadow shadow{r.face, false, {}, {}};
  work.edges.clear(), work.operands.clear(), work.outline.clear();
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
  add_operands(r, work, shadow);
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
    shadow.edges.push_back({lifted(r, frame, border.part.from()),
                            lifted(r, frame, border.part.to()), border.winding, border.part.plane});
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
    if (const std::optional<ShadowReceiver> r = impl_->receiver_of(receiver))
      return impl_->cast_on(*r, *scratch.impl_);
  return {receiver, false, {}, {}};
}

const Canonical& ShadowCaster::casting() const { return impl_->whole; }

std::vector<Shadow> ShadowCaster::all() const {
  std::vector<Shadow> shadows;
  if (impl_ == nullptr) return shadows;
  Scratch scratch;
  for (Index f = 0; f <= impl_->seen.faces.size(); ++f) {
    Shadow shadow = on(f, scratch);
    if (shadow.covered || !shadow.edges.empty() || !shadow.operands.empty())
      shadows.push_back(std::move(shadow));
  }
  return shadows;
}

std::vector<Shadow> cast_shadows(const Canonical& whole, const Canonical& seen, const View& view) {
  return ShadowCaster(whole, seen, view, 1).all();
}

}  // namespace overstrike
