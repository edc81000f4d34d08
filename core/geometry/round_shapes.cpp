// Frustum, ellipsoid and torus: profiles turned about z.
#include <algorithm>

#include "core/geometry/circle.h"
#include "core/geometry/revolve.h"
#include "core/geometry/shape_faces.h"

namespace overstrike {
namespace {

/// The normal of an edge of a profile, the solid on its left.
Vec2 right_of(const Vec2& from, const Vec2& to) { return {to.y - from.y, from.x - to.x}; }

/// Links the chain's points in order; `closed` links the last to the first.
void link_curve(ProfileChain& chain, const std::vector<Vec2>& normals, bool closed) {
  const Index count = static_cast<Index>(chain.points.size());
  for (Index i = 0; i + (closed ? 0 : 1) < count; ++i) {
    const Index next = (i + 1) % count;
    chain.edges.push_back({i, next, normals[i], normals[next], i, false});
  }
}

}  // namespace

RoundCounts round_counts(const Frustum& frustum, double chord) {
  if (frustum.sides > 0) return {frustum.sides, 1, true};
  const double widest = std::max(frustum.bottom_radius, frustum.top_radius);
  const int sides = chords_for(widest, chord, 360);
  return {sides, 1, sagitta(widest, sides, 360) <= chord};
}

Polyhedron faces_of(const Frustum& frustum, double chord, bool normals) {
  const int sides = round_counts(frustum, chord).sides;
  ProfileChain chain;
  chain.points = {{0, 0}};
  if (frustum.bottom_radius > 0) chain.points.push_back({frustum.bottom_radius, 0});
  if (frustum.top_radius > 0) chain.points.push_back({frustum.top_radius, frustum.height});
  chain.points.push_back({0, frustum.height});
  for (Index i = 0; i + 1 < chain.points.size(); ++i) {
    const Vec2 &from = chain.points[i], &to = chain.points[i + 1];
    const Vec2 normal = right_of(from, to);
    chain.edges.push_back({i, i + 1, normal, normal, i, from.y == to.y});
  }
  return revolve(chain, sides, 360, normals);
}

FacetCounts facet_counts(const Ellipsoid& e) {
  if (e.sides > 0 && e.rings > 0) return {e.sides, e.rings};
  if (e.sides > 0) return {e.sides, std::max(2, (e.sides + 1) / 2)};
  return {2 * e.rings, e.rings};
}

/// A facet strays from the surface by the sagitta of its chord along the parallel and then by that
/// of its chord along the meridian; each gets half of `chord`, which makes the fewest facets to
/// second order.
RoundCounts round_counts(const Ellipsoid& ellipsoid, double chord) {
  const FacetCounts counts = facet_counts(ellipsoid);
  if (counts.sides > 0) return {counts.sides, counts.rings, true};
  const Vec3& r = ellipsoid.radii;
  const double wide = std::max(r.x, r.y), largest = std::max(wide, r.z);
  const int sides = chords_for(wide, chord / 2, 360), rings = chords_for(largest, chord / 2, 180);
  return {sides, rings,
          sagitta(wide, sides, 360) <= chord / 2 && sagitta(largest, rings, 180) <= chord / 2};
}

/// The unit sphere stretched.
Polyhedron faces_of(const Ellipsoid& ellipsoid, double chord, bool normals) {
  const Vec3& r = ellipsoid.radii;
  const auto [sides, bands, fine] = round_counts(ellipsoid, chord);
  ProfileChain chain;
  for (int i = 0; i <= bands; ++i) {
    const Vec2 p = turn(i, 2 * bands);  // (cos, sin) of the angle from the lower pole
    chain.points.push_back({p.y, 0 - p.x});
  }
  link_curve(chain, chain.points, false);
  Polyhedron p = revolve(chain, sides, 360, normals);
  for (Vec3& vertex : p.vertices) vertex *= r;
  for (Vec3& normal : p.corner_normals) normal = glm::normalize(normal / r);
  return p;
}

/// Half of `chord` for each circle, as for the ellipsoid.
RoundCounts round_counts(const Torus& torus, double chord) {
  const double widest = torus.major + torus.minor;
  const int sides = chords_for(widest, chord / 2, 360);
  const int around_tube = chords_for(torus.minor, chord / 2, 360);
  return {sides, around_tube,
          sagitta(widest, sides, 360) <= chord / 2 &&
              sagitta(torus.minor, around_tube, 360) <= chord / 2};
}

Polyhedron faces_of(const Torus& torus, double chord, bool normals) {
  const auto [sides, around_tube, fine] = round_counts(torus, chord);
  ProfileChain chain;
  std::vector<Vec2> outward;
  for (int i = 0; i < around_tube; ++i) {
    const Vec2 u = turn(i, around_tube);
    outward.push_back(u);
    chain.points.push_back({torus.major + torus.minor * u.x, torus.minor * u.y});
  }
  link_curve(chain, outward, true);
  return revolve(chain, sides, 360, normals);
}

}  // namespace overstrike
