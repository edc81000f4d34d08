#include "core/visibility/nn74/light_phase.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/visibility/depth.h"
#include "core/visibility/nn74/convex_view.h"
#include "core/visibility/nn74/pairs.h"
#include "core/visibility/nn74/separation.h"

namespace overstrike::nn74 {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// A corner of a polygon in the light's view.
struct Corner {
  Vec2 at;
  bool own;
};

/// Keeps what lies inside the line a -> b, which becomes a side that is not the face's own.
std::vector<Corner> cut(const std::vector<Corner>& polygon, const Vec2& a, const Vec2& b) {
  std::vector<Corner> result;
  const auto height = [&](const Corner& c) { return cross(b - a, c.at - a); };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner& p = polygon[i];
    const Corner& q = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double hp = height(p), hq = height(q);
    if (hp >= 0) result.push_back({p.at, p.own && !(hp == 0 && hq < 0)});
    if (!((hp < 0 && hq > 0) || (hp > 0 && hq < 0))) continue;
    result.push_back({p.at + (q.at - p.at) * (hp / (hp - hq)), hp < 0 && p.own});
  }
  return result;
}

/// One contour's walk over one body (step 4).
class Walk {
 public:
  Walk(const ConvexView& front, const Contour& contour, const ConvexView& back, const Contour& body)
      : front_(front), contour_(contour), back_(back), body_(body) {
    passing_.resize(body.end_face - body.first_face);
  }

  void run();
  /// The contour edges that met a face of the body, in order.
  const std::vector<Index>& passing(Index face) const { return passing_[face - body_.first_face]; }

 private:
  void enter(Index edge, std::vector<Index>& at) const;
  void locate(const Vec2& p, std::vector<Index>& at) const;
  void cross_interior_edges(Index edge, std::vector<Index>& at);

  const ConvexView& front_;
  const Contour& contour_;
  const ConvexView& back_;
  const Contour& body_;
  std::vector<std::vector<Index>> passing_;
};

void Walk::run() {
  std::vector<Index> at;  // the faces that the present edge is known to meet
  for (const Index edge : contour_.sides) {
    const Vec2& corner = front_.from(edge);
    std::erase_if(at, [&](Index face) { return !holds(back_, back_.faces[face], corner); });
    if (at.empty()) locate(corner, at);
    enter(edge, at);
    cross_interior_edges(edge, at);
  }
}

/// The faces where the edge crosses the body's contour.
void Walk::enter(Index edge, std::vector<Index>& at) const {
  for (const Index k : body_.sides)
    if (meet(front_.from(edge), front_.to(edge), back_.from(k), back_.to(k)))
      at.push_back(back_.sides[k].face);
}

/// The faces that hold a corner that no edge has walked to.
void Walk::locate(const Vec2& p, std::vector<Index>& at) const {
  if (p.x < body_.box.low.x || p.x > body_.box.high.x || p.y < body_.box.low.y ||
      p.y > body_.box.high.y)
    return;
  for (Index face = body_.first_face; face < body_.end_face; ++face)
    if (holds(back_, back_.faces[face], p)) at.push_back(face);
}

/// (11), ties counting as crossings: a face too many is not cut.
void Walk::cross_interior_edges(Index edge, std::vector<Index>& at) {
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end()), at.end());
  for (std::size_t next = 0; next < at.size(); ++next) {
    const ViewedFace& face = back_.faces[at[next]];
    passing_[at[next] - body_.first_face].push_back(edge);
    for (Index k = face.first_side; k < face.end_side; ++k) {
      const Index across = back_.sides[k].across;
      if (across == kNone || std::find(at.begin(), at.end(), across) != at.end()) continue;
      if (meet(front_.from(edge), front_.to(edge), back_.from(k), back_.to(k)))
        at.push_back(across);
    }
  }
}

class Caster {
 public:
  Caster(const Canonical& whole, const Canonical& seen, const View& eye)
      : whole_(whole),
        seen_(seen),
        eye_(eye),
        frame_(*whole.light),
        casting_(view_from_light(whole, frame_)),
        receiving_(view_from_light(seen, frame_)) {
    result_.covered.assign(seen.faces.size(), 0);
  }

  LightPhase run() {
    add_ground();
    add_pairs();
    std::stable_sort(result_.shadows.begin(), result_.shadows.end(),
                     [](const FaceShadow& a, const FaceShadow& b) { return a.face < b.face; });
    std::erase_if(result_.shadows, [&](const FaceShadow& s) { return result_.covered[s.face]; });
    return std::move(result_);
  }

 private:
  void add_ground();
  void add_pairs();
  void shade(Index a, Index b);
  void shade_face(Index a, const ViewedFace& face, const std::vector<Index>& passing);
  bool receives(Index face) const;
  bool reaches_over(const CanonicalBody& caster, const CanonicalFace& face) const;
  bool inside_contour(Index a, const ViewedFace& face) const;
  void keep(const ViewedFace& face, const std::vector<Corner>& polygon);

  const Canonical& whole_;
  const Canonical& seen_;
  const View& eye_;
  LightFrame frame_;
  ConvexView casting_, receiving_;
  LightPhase result_;
};

/// (3), as L = (cos theta' cos phi', sin theta' cos phi', sin phi'). The part of a shadow that lies
/// behind the near plane is cut off in phase II.
void Caster::add_ground() {
  if (!whole_.ground_z || !(frame_.light.z > 0)) return;
  for (const Contour& contour : casting_.bodies) {
    std::vector<Vec3> shadow;
    for (const Index side : contour.sides) {
      const Vec3 p = whole_.vertices[casting_.sides[side].from];
      const double drop = (p.z - *whole_.ground_z) / frame_.light.z;
      shadow.emplace_back(p.x - frame_.light.x * drop, p.y - frame_.light.y * drop,
                          *whole_.ground_z);
    }
    if (shadow.size() > 2) result_.ground.push_back(std::move(shadow));
  }
}

void Caster::add_pairs() {
  std::vector<Extent> boxes;
  for (const Contour& c : casting_.bodies) boxes.push_back(c.box);
  for (const Contour& c : receiving_.bodies) boxes.push_back(c.box);
  const Index casters = static_cast<Index>(casting_.bodies.size());
  for (const auto& [i, j] : overlapping_boxes(boxes))
    if (i < casters && j >= casters && whole_.bodies[i].source != seen_.bodies[j - casters].source)
      shade(i, j - casters);
}

void Caster::shade(Index a, Index b) {
  const Overlap overlap = overlap_of(casting_, a, receiving_, b);
  if (overlap == Overlap::independent || front_of(casting_, a, receiving_, b, overlap) <= 0) return;
  const Contour& body = receiving_.bodies[b];
  Walk walk(casting_, casting_.bodies[a], receiving_, body);
  walk.run();
  for (Index f = body.first_face; f < body.end_face; ++f)
    shade_face(a, receiving_.faces[f], walk.passing(f));
}

/// Step 5.
void Caster::shade_face(Index a, const ViewedFace& face, const std::vector<Index>& passing) {
  if (result_.covered[face.face] || !receives(face.face)) return;
  if (!reaches_over(whole_.bodies[a], seen_.faces[face.face])) return;
  if (passing.empty()) {
    if (inside_contour(a, face)) result_.covered[face.face] = 1;
    return;
  }
  std::vector<Corner> polygon;
  for (Index s = face.first_side; s < face.end_side; ++s)
    polygon.push_back({receiving_.from(s), true});
  for (const Index edge : passing) polygon = cut(polygon, casting_.from(edge), casting_.to(edge));
  if (polygon.size() > 2) keep(face, polygon);
}

/// Both the light and the eye see it, from one side.
bool Caster::receives(Index f) const {
  const CanonicalFace& face = seen_.faces[f];
  const Plane& plane = seen_.planes[face.plane];
  if (face.cut) return false;
  const int eye = side_of_eye(plane, face.flipped, eye_.eye);
  return eye != 0 && eye == side_of_direction(plane, face.flipped, frame_.light);
}

/// Some of the caster lies on the light's side of the face's plane: a face never shadows its own
/// plane, and what only touches it from behind does not either.
bool Caster::reaches_over(const CanonicalBody& caster, const CanonicalFace& face) const {
  const Plane& plane = seen_.planes[face.plane];
  const int lit = side_of_direction(plane, false, frame_.light);
  for (Index v = caster.first_vertex; v < caster.end_vertex; ++v)
    if (side_of_point(plane, whole_.vertices[v]) == lit &&
        !has_face_in(whole_, caster, face.plane, v))
      return true;
  return false;
}

/// Of a face that no contour edge passes.
bool Caster::inside_contour(Index a, const ViewedFace& face) const {
  Vec2 middle(0);
  for (Index s = face.first_side; s < face.end_side; ++s) middle += receiving_.from(s);
  middle /= static_cast<double>(face.end_side - face.first_side);
  const std::vector<Index>& sides = casting_.bodies[a].sides;
  return std::all_of(sides.begin(), sides.end(), [&](Index i) {
    return cross(casting_.to(i) - casting_.from(i), middle - casting_.from(i)) > 0;
  });
}

/// Step 6: (12)(13), from the corner of the face that spans the largest triangle.
void Caster::keep(const ViewedFace& face, const std::vector<Corner>& polygon) {
  FaceShadow shadow{face.face, {}, {}};
  double largest = 0;
  for (Index s = face.first_side; s < face.end_side; ++s) {
    const Index before = s == face.first_side ? face.end_side - 1 : s - 1;
    const double area =
        cross(receiving_.to(s) - receiving_.from(s), receiving_.from(before) - receiving_.from(s));
    if (area <= largest) continue;
    largest = area;
    shadow.frame = {receiving_.sides[before].from, receiving_.sides[s].from,
                    receiving_.sides[s].to};
  }
  if (largest == 0) return;
  const Vec2 p2 = receiving_.points[shadow.frame[1]].at;
  const Vec2 u = receiving_.points[shadow.frame[0]].at - p2;
  const Vec2 w = receiving_.points[shadow.frame[2]].at - p2;
  for (const Corner& c : polygon) {
    const Vec2 q = c.at - p2;
    shadow.corners.push_back({cross(q, w) / cross(u, w), cross(u, q) / cross(u, w), c.own});
  }
  result_.shadows.push_back(std::move(shadow));
}

}  // namespace

LightPhase cast(const Canonical& whole, const Canonical& seen, const View& eye) {
  if (!whole.light) {
    LightPhase nothing;
    nothing.covered.assign(seen.faces.size(), 0);
    return nothing;
  }
  return Caster(whole, seen, eye).run();
}

}  // namespace overstrike::nn74
