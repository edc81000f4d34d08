#include "core/geometry/shadeable.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/geometry/face_list.h"
#include "core/geometry/plane_fit.h"
#include "core/geometry/split_face.h"

namespace overstrike {
namespace {

Index first_corner(const Polyhedron& p, Index face) { return p.first_index(p.first_loop(face)); }
Index end_corner(const Polyhedron& p, Index face) { return p.loop_ends[p.face_ends[face] - 1]; }

std::vector<std::vector<Vec3>> loops_of(const Polyhedron& p, Index face) {
  std::vector<std::vector<Vec3>> loops;
  for (Index l = p.first_loop(face); l < p.face_ends[face]; ++l) {
    loops.emplace_back();
    for (const Index v : p.loop(l)) loops.back().push_back(p.vertices[v]);
  }
  return loops;
}

bool is_shadeable(const Polyhedron& p, Index face) {
  const auto first = p.corner_normals.begin() + first_corner(p, face);
  const auto end = p.corner_normals.begin() + end_corner(p, face);
  if (end - first == 3) return true;
  if (std::all_of(first, end, [&](const Vec3& n) { return n == *first; })) return true;
  const auto loops = loops_of(p, face);
  return loops.size() == 1 && is_convex(loops.front(), fit_plane(p, face).normal);
}

using Triangles = std::vector<std::array<Index, 3>>;

/// Over corners, which are numbers into p.indices. Empty when one would have no area.
Triangles triangles_of_face(const Polyhedron& p, Index face, const Vec3& normal) {
  const std::vector<Index> outline = bridged(loops_of(p, face), normal);
  std::vector<Vec3> points;
  for (const Index corner : outline)
    points.push_back(p.vertices[p.indices[first_corner(p, face) + corner]]);
  Triangles triangles = triangles_of(points, normal);
  for (auto& [a, b, c] : triangles) {
    if (!(glm::dot(glm::cross(points[b] - points[a], points[c] - points[a]), normal) > 0))
      return {};
    for (Index* corner : {&a, &b, &c}) *corner = first_corner(p, face) + outline[*corner];
  }
  return triangles;
}

void append_triangles(Polyhedron& out, const Polyhedron& p, const Triangles& triangles,
                      Index plane) {
  for (const auto& [a, b, c] : triangles) {
    out.add_face({p.indices[a], p.indices[b], p.indices[c]});
    for (const Index corner : {a, b, c}) out.corner_normals.push_back(p.corner_normals[corner]);
    out.plane_groups.push_back(plane);
  }
}

}  // namespace

bool is_shadeable(const Polyhedron& p) {
  if (p.corner_normals.empty()) return true;
  for (Index f = 0; f < p.face_count(); ++f)
    if (!is_shadeable(p, f)) return false;
  return true;
}

Polyhedron shadeable(const Polyhedron& polyhedron) {
  Polyhedron p = polyhedron;
  if (p.plane_groups.empty()) {
    p.plane_groups.resize(p.face_count());
    std::iota(p.plane_groups.begin(), p.plane_groups.end(), Index{0});
  }
  Polyhedron out;
  out.vertices = p.vertices;
  for (Index f = 0; f < p.face_count(); ++f) {
    if (is_shadeable(p, f)) {
      append_face(out, p, f, false);
      continue;
    }
    const Vec3 normal = fit_plane(p, f).normal;
    const Triangles triangles = triangles_of_face(p, f, normal);
    append_triangles(out, p, triangles, p.plane_groups[f]);
    if (!triangles.empty()) continue;
    std::fill(p.corner_normals.begin() + first_corner(p, f),
              p.corner_normals.begin() + end_corner(p, f), normal);
    append_face(out, p, f, false);
  }
  return out;
}

}  // namespace overstrike
