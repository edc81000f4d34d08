#include "core/visibility/prepare_shape.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/geometry/repair.h"
#include "core/geometry/shadeable.h"
#include "core/geometry/smooth_normals.h"
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

/// Facets of a mesh file stand for whatever surface they were made from; a polyhedron written out
/// in a scene means its edges, unless it is to be shaded smoothly.
bool stands_for_surface(const Mesh& mesh, bool smooth) { return smooth || !mesh.source.empty(); }

/// Cuts faces that could not be shaded smoothly as they are; the cuts are no creases.
void make_shadeable(PreparedShape& shape) {
  if (is_shadeable(shape.polyhedron)) return;
  Polyhedron cut = shadeable(shape.polyhedron);
  std::map<std::pair<Index, Index>, bool> was_smooth;
  for (std::size_t i = 0; i < shape.edges.size(); ++i)
    was_smooth[std::minmax(shape.edges[i].from, shape.edges[i].to)] = shape.smooth_edge[i];
  shape.polyhedron = std::move(cut);
  shape.edges = pair_edges(shape.polyhedron);
  shape.smooth_edge.clear();
  for (const EdgePair& e : shape.edges) {
    const auto found = was_smooth.find(std::minmax(e.from, e.to));
    shape.smooth_edge.push_back(found == was_smooth.end() || found->second);
  }
}

PreparedShape prepare_mesh(const Mesh& mesh, bool smooth) {
  PreparedShape result;
  Repaired mended = repaired(mesh.polyhedron, {mesh.precision, false, mesh.lines}, result.flaws);
  result.polyhedron = std::move(mended.polyhedron);
  result.closed = !mended.crosses_itself;
  result.precision = mesh.precision;
  Polyhedron& p = result.polyhedron;
  result.edges = pair_edges(p);
  result.smooth_edge.assign(result.edges.size(), false);
  if (!p.corner_normals.empty()) {
    for (std::size_t i = 0; i < result.edges.size(); ++i)
      result.smooth_edge[i] = smooth_by_normals(p, result.edges[i]);
  } else if (stands_for_surface(mesh, smooth)) {
    result.smooth_edge = shallow_edges(p, result.edges);
    if (smooth) p.corner_normals = smooth_normals(p, result.edges, result.smooth_edge);
  }
  if (smooth) make_shadeable(result);
  return result;
}

PreparedShape prepare_solid(const Shape& shape, double chord, bool smooth) {
  PreparedShape result;
  result.polyhedron = tessellate(shape, chord, smooth || is_curved(shape));
  if (std::holds_alternative<FlatPolygon>(shape))
    result.polyhedron = repaired(result.polyhedron, {0, true, {}}, result.flaws).polyhedron;
  Polyhedron& p = result.polyhedron;
  result.edges = pair_edges(p);
  if (smooth && p.corner_normals.empty()) {
    result.smooth_edge = shallow_edges(p, result.edges);
    p.corner_normals = smooth_normals(p, result.edges, result.smooth_edge);
    make_shadeable(result);
  } else {
    for (const EdgePair& e : result.edges) result.smooth_edge.push_back(smooth_by_normals(p, e));
  }
  return result;
}

}  // namespace

PreparedShape prepare_shape(const Shape& shape, double chord, bool smooth) {
  const Mesh* mesh = std::get_if<Mesh>(&shape);
  PreparedShape result =
      mesh != nullptr ? prepare_mesh(*mesh, smooth) : prepare_solid(shape, chord, smooth);
  for (const EdgePair& e : result.edges) result.closed = result.closed && e.right != kNoFace;
  return result;
}

}  // namespace overstrike
