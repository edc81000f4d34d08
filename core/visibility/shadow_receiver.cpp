#include "core/visibility/shadow_receiver.h"

#include <algorithm>

#include "core/visibility/depth.h"
#include "core/visibility/plane_gap.h"
#include "core/visibility/plane_rounding.h"

namespace overstrike {
namespace {

/// The side of a face that both the eye and the light are on, or 0. Of a solid's operands the
/// inside may be seen.
int lit_and_seen_side(const Canonical& c, const CanonicalFace& f, const View& view) {
  const int eye = side_of_eye(c.planes[f.plane], f.flipped, view.eye);
  const int light = side_of_direction(c.planes[f.plane], f.flipped, *c.light);
  if (eye == 0 || eye != light) return 0;
  const bool two_sided = !c.bodies[f.body].closed || c.membership(f.body).solid != kNone;
  return eye > 0 || two_sided ? eye : 0;
}

/// The corners of a face's loops follow each other.
template <class Visit>
void for_each_vertex(const Canonical& c, const CanonicalFace& f, const Visit& visit) {
  for (Index i = c.first_corner(f.first_loop); i < c.first_corner(f.end_loop); ++i)
    visit(c.vertices[c.corners[i]]);
}

/// Where the eye sees a vertex on a plane.
Vec3 seen_on(const Plane& plane, const View& view, const Vec3& p) {
  const Vec3 to_eye = Vec3(view.eye) - p * view.eye.w;
  const double facing = glm::dot(plane.normal, to_eye);
  return facing == 0 ? p : p - to_eye * (height_of_point(plane, p) / facing);
}

/// How far a plane passes its vertices by, at most, and the sizes of what was summed for that.
struct OffPlane {
  double most = 0, size = 0;
};

/// Sets the bounds of the heights from those of its corners.
void set_heights(ShadowReceiver& r, double low, double high, const OffPlane& off) {
  // Along the light the plane passes its vertices by at `most` / |n . L|. What was rounded: two
  // sums of products of at most `size` and twice that, and n . L, whose part of itself is as much
  // of the quotient.
  constexpr double kError = 4 * 0x1p-52;
  const double steep = 1 / std::fabs(r.along_light);
  const double error =
      kError * off.size + steep * (off.most + kError * (2 * off.size + steep * off.most));
  r.low_z = low - 2 * error, r.high_z = high + 2 * error;
}

}  // namespace

std::optional<ShadowReceiver> face_receiver(const Canonical& seen, const View& view,
                                            const LightFrame& frame, Index face) {
  const CanonicalFace& f = seen.faces[face];
  if (f.cut || lit_and_seen_side(seen, f, view) == 0) return std::nullopt;
  ShadowReceiver r{};
  r.face = face, r.body = f.body, r.plane_id = f.plane;
  r.plane = seen.planes[f.plane];
  r.along_light = along(r.plane, frame.light);
  OffPlane off;
  double low = HUGE_VAL, high = -HUGE_VAL;
  const auto add = [&](const Vec3& q) {
    r.region.add(Vec2(q));
    low = std::min(low, q.z), high = std::max(high, q.z);
  };
  for_each_vertex(seen, f, [&](const Vec3& p) {
    off.most = std::max(off.most, std::fabs(glm::dot(r.plane.normal, p) - r.plane.offset));
    off.size = std::max(off.size, std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z));
    add(frame(p));
  });
  off.size += std::fabs(r.plane.offset);
  r.off_plane = off.most > kPlaneRounding * off.size;
  if (r.off_plane) {
    r.region = {}, low = HUGE_VAL, high = -HUGE_VAL;
    for_each_vertex(seen, f, [&](const Vec3& p) { add(frame(seen_on(r.plane, view, p))); });
  }
  set_heights(r, low, high, off);
  return r;
}

std::optional<ShadowReceiver> ground_receiver(const Canonical& seen, const View& view,
                                              const LightFrame& frame) {
  if (!seen.ground_z) return std::nullopt;
  const double z = *seen.ground_z;
  if (!(frame.light.z > 0) || !(view.eye.z - z * view.eye.w > 0)) return std::nullopt;
  ShadowReceiver r{};
  r.face = static_cast<Index>(seen.faces.size());
  r.body = r.plane_id = kNone;
  r.plane = Plane{Vec3(0, 0, 1), z};
  r.along_light = frame.light.z;
  r.region = {Vec2(-HUGE_VAL), Vec2(HUGE_VAL)};
  return r;
}

void convex_outline_of(const ShadowReceiver& r, const Canonical& seen, const View& view,
                       const LightFrame& frame, std::vector<Vec2>& outline) {
  outline.clear();
  const CanonicalFace& f = seen.faces[r.face];
  if (f.end_loop - f.first_loop != 1) return;
  for_each_vertex(seen, f, [&](const Vec3& p) {
    outline.emplace_back(frame(r.off_plane ? seen_on(r.plane, view, p) : p));
  });
  keep_if_convex(outline);
}

Vec3 lifted(const ShadowReceiver& r, const LightFrame& frame, const Vec2& p) {
  const Vec3 q = frame.right * p.x + frame.up * p.y;
  return q + frame.light * ((r.plane.offset - glm::dot(r.plane.normal, q)) / r.along_light);
}

}  // namespace overstrike
