#include "core/visibility/projected_scene.h"

#include <algorithm>
#include <cmath>

namespace overstrike {
namespace {

std::vector<Plane> with_ground(const Canonical& c, const View& view) {
  std::vector<Plane> planes = c.planes;
  planes.push_back({Vec3(0, 0, 1), c.ground_z.value_or(0)});
  if (view.near_plane) planes.push_back(*view.near_plane);
  return planes;
}

}  // namespace

GridPoint to_grid(const View& view, const Vec3& p) {
  const Vec4 h = view.matrix * Vec4(p, 1.0);
  Vec4 size = glm::abs(view.matrix[3]);
  for (int column = 0; column < 3; ++column) size += glm::abs(view.matrix[column] * p[column]);
  const double x = h.x / h.z, y = h.y / h.z, z = h.w / h.z;
  const double most = std::max(std::fabs(x), std::fabs(y));
  const double unit = kPointRounding / std::fabs(h.z);
  return {Vec3(x, y, z), h.z, unit * (std::max(size.x, size.y) + size.z * most),
          unit * (size.w + size.z * std::fabs(z))};
}

double height_error(const Plane& plane, const Vec3& p) {
  return kPointRounding * (glm::dot(glm::abs(plane.normal), glm::abs(p)) + std::fabs(plane.offset));
}

ProjectedScene::ProjectedScene(const Canonical& canonical_input, const View& in_view)
    : canonical(canonical_input),
      view(in_view),
      planes_(with_ground(canonical, view)),
      depths_(planes_, view) {
  points.reserve(canonical.vertices.size());
  for (const Vec3& p : canonical.vertices) points.push_back(to_grid(view, p));
  side_.reserve(canonical.faces.size());
  seen_.reserve(canonical.faces.size());
  plane_start_.assign(canonical.vertices.size() + 1, 0);
  const auto each = [&](const auto& visit) {
    for (const CanonicalFace& f : canonical.faces)
      for (Index l = f.first_loop; l < f.end_loop; ++l)
        for (const Index v : canonical.loop(l)) visit(v, f.plane);
  };
  for (const CanonicalFace& f : canonical.faces) {
    const int side = side_of_eye(canonical.planes[f.plane], f.flipped, view.eye);
    const bool both =
        !canonical.bodies[f.body].closed || f.cut || canonical.membership(f.body).solid != kNone;
    side_.push_back(static_cast<signed char>(side));
    seen_.push_back((side > 0 || (side < 0 && both)) && has_depth(f.plane));
  }
  each([&](Index v, Index) { ++plane_start_[v + 1]; });
  for (std::size_t i = 1; i < plane_start_.size(); ++i) plane_start_[i] += plane_start_[i - 1];
  planes_of_vertex_.resize(plane_start_.back());
  std::vector<Index> at(plane_start_.begin(), plane_start_.end() - 1);
  each([&](Index v, Index plane) { planes_of_vertex_[at[v]++] = plane; });
  has_ground_ = canonical.ground_z && has_depth(ground()) &&
                view.eye.z - *canonical.ground_z * view.eye.w > 0;
}

bool ProjectedScene::touches(Index vertex, Index plane) const {
  for (Index i = plane_start_[vertex]; i < plane_start_[vertex + 1]; ++i)
    if (planes_of_vertex_[i] == plane) return true;
  return false;
}

double ProjectedScene::height(Index plane_id, Index vertex) const {
  if (touches(vertex, plane_id)) return 0;
  return height(plane_id, canonical.vertices[vertex]);
}

double ProjectedScene::height(Index plane_id, const Vec3& p) const {
  const Plane& on = plane(plane_id);
  const double h = glm::dot(on.normal, p) - on.offset;
  return std::fabs(h) <= height_error(on, p) ? 0 : h;
}

}  // namespace overstrike
