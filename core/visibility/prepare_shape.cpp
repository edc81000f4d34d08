#include "core/visibility/prepare_shape.h"

#include <algorithm>

#include "core/geometry/tessellate.h"

namespace overstrike {
namespace {

/// Corner normals closer than this belong to one smooth surface: a cosine, 2.6 degrees.
constexpr double kSameNormal = 0.999;

/// The corner normal of `face` at `vertex`.
Vec3 normal_at(const Polyhedron& p, Index face, Index vertex) {
  const Index first = p.first_index(p.first_loop(face));
  const Index end = p.loop_ends[p.face_ends[face] - 1];
  for (Index i = first; i < end; ++i)
    if (p.indices[i] == vertex) return p.corner_normals[i];
  return Vec3(0.0);
}

/// One curved surface has one normal at both faces' corners; a cone's tip has none, so that either
/// end decides.
bool smooth_by_normals(const Polyhedron& p, const EdgePair& e) {
  if (e.right == kNoFace || p.corner_normals.empty()) return false;
  const auto same = [&](Index v) {
    return glm::dot(normal_at(p, e.left, v), normal_at(p, e.right, v)) >= kSameNormal;
  };
  return same(e.from) || same(e.to);
}

}  // namespace

PreparedShape prepare_shape(const Shape& shape, double chord) {
  PreparedShape result;
  const Mesh* mesh = std::get_if<Mesh>(&shape);
  result.polyhedron =
      mesh != nullptr ? mesh->polyhedron : tessellate(shape, chord, is_curved(shape));
  if (mesh != nullptr) result.precision = mesh->precision;
  result.edges = pair_edges(result.polyhedron);
  for (const EdgePair& e : result.edges) {
    result.smooth_edge.push_back(smooth_by_normals(result.polyhedron, e));
    if (e.right == kNoFace) result.closed = false;
  }
  return result;
}

}  // namespace overstrike
