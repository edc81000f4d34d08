#include "core/visibility/equal_shapes.h"

#include <functional>

namespace overstrike {
namespace {

/// Of the vertices; -0 is 0.
std::size_t hash_of(const PreparedShape& shape) {
  std::size_t hash = shape.polyhedron.indices.size();
  for (const Vec3& p : shape.polyhedron.vertices)
    for (int i = 0; i < 3; ++i)
      hash = (hash ^ std::hash<double>()(p[i] + 0.0)) * std::size_t{0x9E3779B97F4A7C15};
  return hash;
}

bool are_same(const PreparedShape& a, const PreparedShape& b) {
  const Polyhedron &p = a.polyhedron, &q = b.polyhedron;
  return p.vertices == q.vertices && p.indices == q.indices && p.loop_ends == q.loop_ends &&
         p.face_ends == q.face_ends && p.plane_groups == q.plane_groups &&
         p.corner_normals == q.corner_normals && a.smooth_edge == b.smooth_edge &&
         a.closed == b.closed && a.precision == b.precision;
}

}  // namespace

const PreparedShape* EqualShapes::first_of(const PreparedShape& shape) {
  const auto [at, is_new] = known_.try_emplace(&shape, &shape);
  if (!is_new) return at->second;
  const std::size_t hash = hash_of(shape);
  const auto [first, end] = by_hash_.equal_range(hash);
  for (auto other = first; other != end; ++other)
    if (are_same(shape, *other->second)) return at->second = other->second;
  by_hash_.emplace(hash, &shape);
  return &shape;
}

}  // namespace overstrike
