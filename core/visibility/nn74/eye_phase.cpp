#include "core/visibility/nn74/eye_phase.h"

#include <algorithm>
#include <array>

#include "core/visibility/depth.h"
#include "core/visibility/nn74/convex_view.h"
#include "core/visibility/nn74/pairs.h"
#include "core/visibility/tie.h"

namespace overstrike::nn74 {
namespace {

std::vector<Vec3> cut(const std::vector<Vec3>& polygon, const Plane& keep) {
  std::vector<Vec3> result;
  const auto height = [&](const Vec3& p) { return glm::dot(keep.normal, p) - keep.offset; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& a = polygon[i];
    const Vec3& b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double ha = height(a), hb = height(b);
    if (ha >= 0) result.push_back(a);
    if ((ha < 0 && hb > 0) || (ha > 0 && hb < 0)) result.push_back(a + (b - a) * (ha / (ha - hb)));
  }
  return result;
}

class Builder {
 public:
  Builder(Picture& out, const View& view)
      : out_(out), c_(out.canonical), view_(view), seen_(view_from_eye(c_, view)) {}

  void build(const LightPhase& light) {
    add_faces(light.covered);
    add_bodies();
    add_face_shadows(light.shadows);
    add_ground_shadows(light.ground);
    order_pairs();
  }

 private:
  void add_faces(const std::vector<char>& covered);
  void add_bodies();
  void add_face_shadows(const std::vector<FaceShadow>& shadows);
  void add_ground_shadows(const std::vector<std::vector<Vec3>>& shadows);
  void order_pairs();
  Vec2 project(const Vec3& p) const { return Vec2(view_.project(p)); }

  Picture& out_;
  const Canonical& c_;
  const View& view_;
  ConvexView seen_;
};

void Builder::add_faces(const std::vector<char>& covered) {
  for (const ViewedFace& f : seen_.faces) {
    const CanonicalFace& face = c_.faces[f.face];
    const bool behind = side_of_eye(c_.planes[face.plane], face.flipped, view_.eye) < 0;
    const FaceShade shade = shade_of(c_, face, behind);
    PictureFace p{f.face,
                  face.plane,
                  face.body,
                  shade.lit ? Kind::lit : Kind::shade,
                  shade.density,
                  0,
                  covered[f.face] != 0,
                  {},
                  {}};
    if (face.cut) p.kind = Kind::cut;
    p.in_shadow = std::clamp(c_.law.hmax * c_.bodies[face.body].density_factor, 0.0, 1.0);
    for (Index s = f.first_side; s < f.end_side; ++s)
      p.outline.add(seen_.from(s), seen_.to(s), seen_.sides[s].across, false);
    p.outline.sort();
    out_.faces.push_back(std::move(p));
  }
}

void Builder::add_bodies() {
  for (Index b = 0; b < seen_.bodies.size(); ++b) {
    PictureBody body{b, {}};
    const Contour& contour = seen_.bodies[b];
    for (const Index s : contour.sides)
      body.outline.add(seen_.from(s), seen_.to(s), seen_.sides[s].face, false);
    body.outline.sort();
    out_.bodies.push_back(std::move(body));
  }
}

/// Step 2. Light and eye see a receiver from one side: counter-clockwise from the light is
/// clockwise in the grid.
void Builder::add_face_shadows(const std::vector<FaceShadow>& shadows) {
  std::vector<Index> number(c_.faces.size(), kNone);
  for (Index f = 0; f < out_.faces.size(); ++f) number[out_.faces[f].face] = f;
  for (const FaceShadow& shadow : shadows) {
    const Vec3 p2 = c_.vertices[shadow.frame[1]];
    const Vec3 u = c_.vertices[shadow.frame[0]] - p2, w = c_.vertices[shadow.frame[2]] - p2;
    const auto place = [&](const ShadowCorner& s) { return project(p2 + u * s.t1 + w * s.t2); };
    Outline outline;
    for (std::size_t i = 0; i < shadow.corners.size(); ++i) {
      const ShadowCorner& a = shadow.corners[i];
      const ShadowCorner& b = shadow.corners[i + 1 == shadow.corners.size() ? 0 : i + 1];
      outline.add(place(b), place(a), kNone, a.own);
    }
    outline.sort();
    if (outline.top < outline.bottom)
      out_.faces[number[shadow.face]].shadows.push_back(std::move(outline));
  }
}

void Builder::add_ground_shadows(const std::vector<std::vector<Vec3>>& shadows) {
  if (!c_.ground_z || !(view_.eye.z - *c_.ground_z * view_.eye.w > 0)) return;
  for (const std::vector<Vec3>& shadow : shadows) {
    const std::vector<Vec3> polygon = view_.near_plane ? cut(shadow, *view_.near_plane) : shadow;
    Outline outline;
    for (std::size_t i = 0; i < polygon.size(); ++i)
      outline.add(project(polygon[i + 1 == polygon.size() ? 0 : i + 1]), project(polygon[i]), kNone,
                  false);
    outline.sort();
    if (outline.top < outline.bottom) out_.ground_shadows.push_back(std::move(outline));
  }
}

void Builder::order_pairs() {
  out_.orders.resize(seen_.bodies.size());
  std::vector<Extent> boxes;
  for (const Contour& contour : seen_.bodies) boxes.push_back(contour.box);
  for (const auto& [a, b] : overlapping_boxes(boxes)) {
    const Overlap overlap = overlap_of(seen_, a, seen_, b);
    if (overlap == Overlap::independent) continue;
    const int front = front_of(seen_, a, seen_, b, overlap);
    if (front == 0) continue;
    out_.orders[a].push_back({b, front});
    out_.orders[b].push_back({a, -front});
  }
  for (std::vector<Picture::Order>& order : out_.orders)
    std::sort(order.begin(), order.end(),
              [](const Picture::Order& p, const Picture::Order& q) { return p.other < q.other; });
}

}  // namespace

void Outline::add(const Vec2& a, const Vec2& b, Index face, bool own) {
  top = std::min(top, a.y), bottom = std::max(bottom, a.y);
  if (a.y == b.y) return;
  const bool down = a.y < b.y;
  const Vec2& p = down ? a : b;
  const Vec2& q = down ? b : a;
  (down ? right : left).push_back({p.x, p.y, q.x, q.y, (q.x - p.x) / (q.y - p.y), face, own});
}

void Outline::sort() {
  const auto higher = [](const Border& a, const Border& b) { return a.y0 < b.y0; };
  std::stable_sort(left.begin(), left.end(), higher);
  std::stable_sort(right.begin(), right.end(), higher);
}

const Border* active(const std::vector<Border>& chain, double y) {
  auto next = std::upper_bound(chain.begin(), chain.end(), y,
                               [](double at, const Border& b) { return at < b.y0; });
  // Chains are monotonic but for the rounding of their corners: the border before the next, or one
  // that rounding has put before it.
  while (next != chain.begin())
    if (y < (--next)->y1) return &*next;
  return nullptr;
}

int Picture::front(Index a, Index b) const {
  const std::vector<Order>& order = orders[a];
  const auto at = std::lower_bound(order.begin(), order.end(), b,
                                   [](const Order& o, Index other) { return o.other < other; });
  return at != order.end() && at->other == b ? at->front : 0;
}

bool Picture::wins_tie(Index f, Index g) const {
  return overstrike::wins_tie(canonical, faces[f].face, faces[g].face);
}

Picture look(const Canonical& seen, const View& view, const LightPhase& light) {
  Picture picture{view.grid.columns, view.grid.rows, seen, {}, {}, {}, 0, {}};
  picture.ground_density = std::clamp(seen.law.hmax * seen.law.ground_shadow_factor, 0.0, 1.0);
  Builder(picture, view).build(light);
  return picture;
}

}  // namespace overstrike::nn74
