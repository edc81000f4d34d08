#include <algorithm>

#include "core/geometry/polygon.h"
#include "core/geometry/shape_faces.h"

namespace overstrike {
namespace {

/// Faces of a solid whose vertices stand as those of a box do: 0..3 below, counter-clockwise from
/// (-x, -y), 4..7 above them.
void add_box_faces(Polyhedron& p) {
  p.add_face({0, 3, 2, 1});
  p.add_face({4, 5, 6, 7});
  p.add_face({0, 1, 5, 4});
  p.add_face({1, 2, 6, 5});
  p.add_face({2, 3, 7, 6});
  p.add_face({3, 0, 4, 7});
}

}  // namespace

Polyhedron faces_of(const Box& box) {
  const double x = box.size.x / 2, y = box.size.y / 2, z = box.size.z;
  Polyhedron p;
  p.vertices = {{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0},
                {-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}};
  add_box_faces(p);
  return p;
}

Polyhedron faces_of(const Wedge& wedge) {
  const double x = wedge.size.x / 2, y = wedge.size.y / 2, z = wedge.size.z;
  const double left = wedge.top_shift - wedge.top / 2, right = wedge.top_shift + wedge.top / 2;
  Polyhedron p;
  p.vertices = {{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}, {left, -y, z}};
  if (left < right) {
    p.vertices.insert(p.vertices.end(), {{right, -y, z}, {right, y, z}, {left, y, z}});
    add_box_faces(p);
    return p;
  }
  p.add_vertex({left, y, z});
  p.add_face({0, 3, 2, 1});
  p.add_face({0, 1, 4});
  p.add_face({1, 2, 5, 4});
  p.add_face({2, 3, 5});
  p.add_face({3, 0, 4, 5});
  return p;
}

Polyhedron faces_of(const Tetrahedron& tetrahedron) {
  const Vec3* v = tetrahedron.vertices;
  Polyhedron p;
  p.vertices.assign(v, v + 4);
  if (glm::dot(glm::cross(v[1] - v[0], v[2] - v[0]), v[3] - v[0]) < 0)
    std::swap(p.vertices[2], p.vertices[3]);
  p.add_face({0, 2, 1});
  p.add_face({0, 1, 3});
  p.add_face({1, 2, 3});
  p.add_face({2, 0, 3});
  return p;
}

/// The outline as it was given; holes are turned against it.
Polyhedron faces_of(const FlatPolygon& polygon) {
  Polyhedron p;
  const Vec3 front = vector_area(polygon.loops.front());
  for (const std::vector<Vec3>& loop : polygon.loops) {
    std::vector<Index> corners;
    for (const Vec3& point : loop) corners.push_back(p.add_vertex(point));
    const bool hole = &loop != &polygon.loops.front();
    if (hole && glm::dot(vector_area(loop), front) > 0)
      std::reverse(corners.begin(), corners.end());
    p.add_loop(corners);
  }
  p.end_face();
  return p;
}

}  // namespace overstrike
