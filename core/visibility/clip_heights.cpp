#include "core/visibility/clip_heights.h"

#include <cmath>

#include "core/visibility/plane_gap.h"
#include "core/visibility/plane_rounding.h"

namespace overstrike {
namespace {

/// The least cosine between a face and the clip plane at which the face's plane is asked. A steeper
/// one is met in a line that is off sideways by less than its vertices are off it.
constexpr double kFlat = 0.5;

double reach_of(const Vec3& p) { return std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z); }

/// Per vertex of the body its flattest face, or kNone where there is no flat one.
std::vector<Index> flattest_faces(const Canonical& c, const CanonicalBody& body,
                                  const Vec3& normal) {
  std::vector<Index> flattest(body.end_vertex - body.first_vertex, kNone);
  const auto cosine = [&](Index face) {
    return std::fabs(glm::dot(c.planes[c.faces[face].plane].normal, normal));
  };
  for (Index f = body.first_face; f < body.end_face; ++f) {
    const double flat = cosine(f);
    if (flat < kFlat) continue;
    const Index end = c.loop_ends[c.faces[f].end_loop - 1];
    for (Index i = c.first_corner(c.faces[f].first_loop); i < end; ++i) {
      Index& best = flattest[c.corners[i] - body.first_vertex];
      if (best == kNone || flat > cosine(best)) best = f;
    }
  }
  return flattest;
}

}  // namespace

// A plane's height over a vertex differs from the vertex' own by what they are apart over the
// cosine; doubled for the rounding of the height.
double clip_rounding(const Plane& keep, double reach) {
  return 2 * kPlaneRounding / kFlat * (reach + std::fabs(keep.offset));
}

void clip_heights(const Canonical& c, const CanonicalBody& body, const Plane& keep,
                  std::vector<double>& heights) {
  heights.clear();
  bool near = false;
  const auto is_near = [&](const Vec3& p, double height) {
    return std::fabs(height) <= clip_rounding(keep, reach_of(p));
  };
  for (Index v = body.first_vertex; v < body.end_vertex; ++v) {
    const Vec3& p = c.vertices[v];
    heights.push_back(glm::dot(keep.normal, p) - keep.offset);
    near = near || is_near(p, heights.back());
  }
  if (!near) return;
  const std::vector<Index> flattest = flattest_faces(c, body, keep.normal);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const Vec3& p = c.vertices[body.first_vertex + i];
    if (flattest[i] == kNone || !is_near(p, heights[i])) continue;
    const Plane& plane = c.planes[c.faces[flattest[i]].plane];
    const PlaneGap gap(plane, keep, keep.normal, reach_of(p));
    heights[i] = gap.at(p) / std::fabs(glm::dot(plane.normal, keep.normal));
  }
}

}  // namespace overstrike
