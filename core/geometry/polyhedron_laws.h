#pragma once
// For tests: what must hold of the faces of a solid, measured.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/geometry/polyhedron.h"

namespace overstrike {

/// Directed edges that do not have exactly one opposite, or that occur twice.
inline int unpaired_edges(const Polyhedron& p) {
  std::map<std::pair<Index, Index>, int> count;
  for (Index l = 0; l < p.loop_ends.size(); ++l) {
    const auto loop = p.loop(l);
    for (std::size_t i = 0; i < loop.size(); ++i) ++count[{loop[i], loop[(i + 1) % loop.size()]}];
  }
  int unpaired = 0;
  for (const auto& [edge, times] : count) {
    const auto opposite = count.find({edge.second, edge.first});
    if (times != 1 || opposite == count.end()) ++unpaired;
  }
  return unpaired;
}

inline int equal_vertices(const Polyhedron& p) {
  std::set<std::array<double, 3>> places;
  for (const Vec3& v : p.vertices) places.insert({v.x + 0.0, v.y + 0.0, v.z + 0.0});
  return static_cast<int>(p.vertices.size() - places.size());
}

/// Signed volume, about the first vertex, by fans.
inline double volume(const Polyhedron& p) {
  double sum = 0;
  for (Index l = 0; l < p.loop_ends.size(); ++l) {
    const auto loop = p.loop(l);
    const Vec3 o = p.vertices.front(), a = p.vertices[loop[0]] - o;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
      sum += glm::dot(a, glm::cross(p.vertices[loop[i]] - o, p.vertices[loop[i + 1]] - o));
  }
  return sum / 6;
}

/// V - E + F, each hole's loop counted as joined to its outline by an edge.
inline int euler_characteristic(const Polyhedron& p) {
  const int holes = static_cast<int>(p.loop_ends.size() - p.face_count());
  return static_cast<int>(p.vertices.size()) - static_cast<int>(p.indices.size() / 2) +
         static_cast<int>(p.face_count()) - holes;
}

/// Area vector of a face, holes included.
inline Vec3 face_area(const Polyhedron& p, Index face) {
  Vec3 sum{0};
  for (Index l = p.first_loop(face); l < p.face_ends[face]; ++l) {
    const auto loop = p.loop(l);
    const Vec3 a = p.vertices[loop[0]];
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
      sum += glm::cross(p.vertices[loop[i]] - a, p.vertices[loop[i + 1]] - a);
  }
  return sum / 2.0;
}

inline double extent(const Polyhedron& p) {
  double size = 0;
  for (const Vec3& v : p.vertices) size = std::max(size, glm::length(v));
  return size;
}

/// How far a face's corners lie from its mean plane, in units of 2^-52 of the solid's extent: the
/// backward error of the corners' coordinates.
inline double worst_unevenness(const Polyhedron& p) {
  double worst = 0;
  for (Index face = 0; face < p.face_count(); ++face) {
    const Vec3 normal = glm::normalize(face_area(p, face));
    double low = 1e300, high = -1e300;
    for (Index i = p.first_index(p.first_loop(face)); i < p.loop_ends[p.face_ends[face] - 1]; ++i) {
      const double depth = glm::dot(normal, p.vertices[p.indices[i]]);
      low = std::min(low, depth), high = std::max(high, depth);
    }
    worst = std::max(worst, high - low);
  }
  return worst / (0x1p-52 * extent(p));
}

/// The same for the corners of all faces that share a plane number.
inline double worst_group_unevenness(const Polyhedron& p) {
  std::map<Index, Vec3> normals;
  std::map<Index, std::pair<double, double>> spans;
  for (Index face = 0; face < p.plane_groups.size(); ++face) {
    const Vec3 normal =
        normals.try_emplace(p.plane_groups[face], glm::normalize(face_area(p, face))).first->second;
    auto& span = spans.try_emplace(p.plane_groups[face], 1e300, -1e300).first->second;
    for (Index i = p.first_index(p.first_loop(face)); i < p.loop_ends[p.face_ends[face] - 1]; ++i) {
      const double depth = glm::dot(normal, p.vertices[p.indices[i]]);
      span = {std::min(span.first, depth), std::max(span.second, depth)};
    }
  }
  double worst = 0;
  for (const auto& [plane, span] : spans) worst = std::max(worst, span.second - span.first);
  return worst / (0x1p-52 * extent(p));
}

/// The bytes of everything in it.
inline bool identical(const Polyhedron& a, const Polyhedron& b) {
  return a.vertices == b.vertices && a.indices == b.indices && a.loop_ends == b.loop_ends &&
         a.face_ends == b.face_ends && a.corner_normals == b.corner_normals &&
         a.plane_groups == b.plane_groups;
}

}  // namespace overstrike
