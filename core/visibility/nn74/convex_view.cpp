#include "core/visibility/nn74/convex_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/visibility/depth.h"

namespace overstrike::nn74 {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

/// Step 1 of a view: which faces are front (4)(5), and what lies across each of their sides.
class Builder {
 public:
  /// `mirrored`: the view's y points down, so that faces that are counter-clockwise from outside
  /// are clockwise there.
  Builder(ConvexView& out, bool mirrored) : out_(out), c_(out.canonical), mirrored_(mirrored) {}

  void build() {
    for (const CanonicalBody& body : c_.bodies) add(body);
  }

 private:
  void add(const CanonicalBody& body);
  void add_face(Index f, bool from_behind);
  void pair_sides(Index first, Index end);
  void chain(Contour& contour, Index first, Index end);

  ConvexView& out_;
  const Canonical& c_;
  bool mirrored_;
};

void Builder::add(const CanonicalBody& body) {
  Contour contour;
  contour.first_face = static_cast<Index>(out_.faces.size());
  const Index first = static_cast<Index>(out_.sides.size());
  for (Index f = body.first_face; f < body.end_face; ++f) {
    const CanonicalFace& face = c_.faces[f];
    const int side = side_of_eye(c_.planes[face.plane], face.flipped, out_.viewer);
    if (side > 0 || (side < 0 && !body.closed)) add_face(f, side < 0);
  }
  contour.end_face = static_cast<Index>(out_.faces.size());
  const Index end = static_cast<Index>(out_.sides.size());
  pair_sides(first, end);
  chain(contour, first, end);
  out_.bodies.push_back(std::move(contour));
}

void Builder::add_face(Index f, bool from_behind) {
  const std::span<const Index> loop = c_.loop(c_.faces[f].first_loop);
  const Index number = static_cast<Index>(out_.faces.size());
  ViewedFace face{f, static_cast<Index>(out_.sides.size()), 0, Vec3(0), Vec3(0)};
  const std::size_t n = loop.size();
  const bool reverse = mirrored_ != from_behind;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = reverse ? n - 1 - i : i;
    const std::size_t b = reverse ? (a == 0 ? n - 1 : a - 1) : (a + 1 == n ? 0 : a + 1);
    out_.sides.push_back({loop[a], loop[b], number, kNone});
  }
  face.end_side = static_cast<Index>(out_.sides.size());
  out_.faces.push_back(face);
}

/// A side between two front faces is there twice, once in each direction: an interior edge.
void Builder::pair_sides(Index first, Index end) {
  std::map<std::pair<Index, Index>, Index> known;
  for (Index s = first; s < end; ++s) known[{out_.sides[s].from, out_.sides[s].to}] = s;
  for (Index s = first; s < end; ++s) {
    const auto twin = known.find({out_.sides[s].to, out_.sides[s].from});
    if (twin != known.end()) out_.sides[s].across = out_.sides[twin->second].face;
  }
}

/// Contour edges chain into one contour.
void Builder::chain(Contour& contour, Index first, Index end) {
  std::map<Index, Index> leaving;
  for (Index s = first; s < end; ++s)
    if (out_.sides[s].across == kNone) leaving.emplace(out_.sides[s].from, s);
  if (leaving.empty()) return;
  const Index start = leaving.begin()->second;
  for (Index s = start; contour.sides.size() < leaving.size();) {
    contour.sides.push_back(s);
    contour.box.add(out_.from(s));
    const auto next = leaving.find(out_.sides[s].to);
    if (next == leaving.end() || next->second == start) break;
    s = next->second;
  }
}

/// near of a plane from the light: n . (x R + y U + near L) = offset.
void set_depths_from_light(ConvexView& view, const LightFrame& frame) {
  for (ViewedFace& f : view.faces) {
    const Plane& plane = view.canonical.planes[view.canonical.faces[f.face].plane];
    const double along = glm::dot(plane.normal, frame.light);
    const Vec3 terms(-glm::dot(plane.normal, frame.right), -glm::dot(plane.normal, frame.up),
                     plane.offset);
    if (along == 0) continue;
    f.depth = terms / along;
    // Each scalar product of unit vectors rounds by at most 2 kEps, and so does `along`.
    const double relative = 2 * kEps / std::fabs(along) + 2 * kEps;
    f.depth_error = (Vec3(2 * kEps, 2 * kEps, 0) / std::fabs(along)) + glm::abs(f.depth) * relative;
  }
}

void set_depths_from_eye(ConvexView& view, const View& eye) {
  const DepthField depths(view.canonical.planes, eye);
  for (ViewedFace& f : view.faces) {
    const DepthPlane& d = depths[view.canonical.faces[f.face].plane];
    f.depth = Vec3(d.a, d.b, d.c);
    f.depth_error = Vec3(d.ea, d.eb, d.ec);
  }
}

}  // namespace

ConvexView view_from_light(const Canonical& canonical, const LightFrame& frame) {
  ConvexView view{canonical, Vec4(frame.light, 0), {}, {}, {}, {}};
  view.points.reserve(canonical.vertices.size());
  for (const Vec3& p : canonical.vertices) {
    const Vec3 q = frame(p);
    // A scalar product with a unit vector rounds by at most 2 kEps of the sum of its terms.
    const double error = 4 * kEps * (std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z));
    view.points.push_back({Vec2(q), q.z, error, error});
  }
  Builder(view, false).build();
  set_depths_from_light(view, frame);
  return view;
}

ConvexView view_from_eye(const Canonical& canonical, const View& eye) {
  ConvexView view{canonical, eye.eye, {}, {}, {}, {}};
  view.points.reserve(canonical.vertices.size());
  for (const Vec3& p : canonical.vertices) {
    const Vec4 h = eye.matrix * Vec4(p, 1.0);
    Vec4 size(0);
    for (int column = 0; column < 4; ++column)
      size += glm::abs(eye.matrix[column] * (column < 3 ? p[column] : 1.0));
    const Vec3 q(h.x / h.z, h.y / h.z, h.w / h.z);
    // Sums of four products round by at most 2 kEps of their terms; the quotient adds a kEps.
    const auto error = [&](double value, double terms) {
      return 2 * kEps * (terms + size.z * std::fabs(value)) / std::fabs(h.z) +
             kEps * std::fabs(value);
    };
    view.points.push_back(
        {Vec2(q), q.z, std::max(error(q.x, size.x), error(q.y, size.y)), error(q.z, size.w)});
  }
  Builder(view, true).build();
  set_depths_from_eye(view, eye);
  return view;
}

}  // namespace overstrike::nn74
