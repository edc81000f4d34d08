#include "core/geometry/smooth_normals.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/geometry/direction.h"
#include "core/geometry/plane_fit.h"
#include "core/geometry/trig.h"

namespace overstrike {
namespace {

std::vector<Vec3> face_normals(const Polyhedron& p) {
  std::vector<Vec3> normals(p.face_count());
  for (Index f = 0; f < p.face_count(); ++f) normals[f] = fit_plane(p, f).normal;
  return normals;
}

/// The corner of a face at a vertex. Precondition: it has one.
Index corner_of(const Polyhedron& p, Index face, Index vertex) {
  Index i = p.first_index(p.first_loop(face));
  while (p.indices[i] != vertex) ++i;
  return i;
}

class Corners {
 public:
  explicit Corners(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }
  Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index a, Index b) {
    const Index low = std::min(root(a), root(b)), high = std::max(root(a), root(b));
    parent_[high] = low;
  }

 private:
  std::vector<Index> parent_;
};

/// The face's angle at its corner, in degrees.
double angle_at(const Polyhedron& p, Index loop, Index corner) {
  const Index first = p.first_index(loop), end = p.loop_ends[loop];
  const Vec3 here = p.vertices[p.indices[corner]];
  const Vec3 back = p.vertices[p.indices[corner == first ? end - 1 : corner - 1]] - here;
  const Vec3 on = p.vertices[p.indices[corner + 1 == end ? first : corner + 1]] - here;
  return acos_deg(std::clamp(glm::dot(unit(back), unit(on)), -1.0, 1.0));
}

}  // namespace

std::vector<bool> shallow_edges(const Polyhedron& polyhedron, const std::vector<EdgePair>& edges) {
  const std::vector<Vec3> normals = face_normals(polyhedron);
  std::vector<bool> shallow(edges.size(), false);
  for (std::size_t i = 0; i < edges.size(); ++i)
    shallow[i] = edges[i].right != kNoFace &&
                 glm::dot(normals[edges[i].left], normals[edges[i].right]) >= kCreaseCosine;
  return shallow;
}

std::vector<Vec3> smooth_normals(const Polyhedron& p, const std::vector<EdgePair>& edges,
                                 const std::vector<bool>& smooth) {
  Corners corners(p.indices.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (smooth[i])
      for (const Index v : {edges[i].from, edges[i].to})
        corners.join(corner_of(p, edges[i].left, v), corner_of(p, edges[i].right, v));
  const std::vector<Vec3> normals = face_normals(p);
  std::vector<Vec3> sums(p.indices.size(), Vec3(0.0));
  std::vector<Index> joined(p.indices.size(), 0);
  for (Index f = 0; f < p.face_count(); ++f)
    for (Index l = p.first_loop(f); l < p.face_ends[f]; ++l)
      for (Index i = p.first_index(l); i < p.loop_ends[l]; ++i) {
        sums[corners.root(i)] += normals[f] * angle_at(p, l, i);
        ++joined[corners.root(i)];
      }
  std::vector<Vec3> result;
  for (Index f = 0; f < p.face_count(); ++f)
    for (Index i = p.first_index(p.first_loop(f)); i < p.loop_ends[p.face_ends[f] - 1]; ++i) {
      const Index root = corners.root(i);
      result.push_back(joined[root] == 1 ? normals[f] : unit(sums[root]));
    }
  return result;
}

}  // namespace overstrike
