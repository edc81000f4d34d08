// Smooth shading: which normals shapes get, which edges stay, which faces are cut for it.
#include "core/visibility/prepare_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/circle.h"
#include "core/geometry/direction.h"
#include "core/geometry/plane_fit.h"
#include "core/geometry/shadeable.h"

namespace overstrike {
namespace {

/// Degrees do not matter for chords here: shapes with sides, and flat ones.
PreparedShape smooth(const Shape& shape) { return prepare_shape(shape, 1, true); }

long creases(const PreparedShape& s) {
  return std::count(s.smooth_edge.begin(), s.smooth_edge.end(), false);
}

template <class Check>
void each_corner(const Polyhedron& p, const Check& check) {
  ASSERT_EQ(p.corner_normals.size(), p.indices.size());
  for (Index f = 0; f < p.face_count(); ++f)
    for (Index i = p.first_index(p.first_loop(f)); i < p.loop_ends[p.face_ends[f] - 1]; ++i)
      check(fit_plane(p, f).normal, p.vertices[p.indices[i]], p.corner_normals[i]);
}

double area(const Polyhedron& p) {
  double sum = 0;
  for (Index f = 0; f < p.face_count(); ++f) sum += fit_plane(p, f).area;
  return sum;
}

TEST(SmoothShading, OfAPrismIsItsCylinders) {
  for (const int sides : {3, 6, 8, 40}) {
    const PreparedShape prism = smooth(Frustum{2, 2, 5, sides});
    EXPECT_EQ(creases(prism), 2 * sides);
    each_corner(prism.polyhedron, [](const Vec3& face, const Vec3& at, const Vec3& normal) {
      const Vec3 wanted = face.z != 0 ? face : Vec3(at.x / 2, at.y / 2, 0);
      EXPECT_LT(max_norm(normal - wanted), 1e-15);
    });
  }
  EXPECT_TRUE(prepare_shape(Frustum{2, 2, 5, 8}, 1, false).polyhedron.corner_normals.empty());
}

TEST(SmoothShading, OfAPolyhedralSphereIsTheSpheres) {
  const PreparedShape sphere = smooth(Ellipsoid{Vec3(2), 8, 5});
  EXPECT_EQ(creases(sphere), 0);
  each_corner(sphere.polyhedron, [](const Vec3&, const Vec3& at, const Vec3& normal) {
    EXPECT_LT(max_norm(normal - at / 2.0), 1e-15);
  });
}

TEST(SmoothShading, KeepsEdgesOf30DegreesAndMore) {
  const PreparedShape box = smooth(Box{{1, 2, 3}});
  EXPECT_EQ(creases(box), 12);
  each_corner(box.polyhedron, [](const Vec3& face, const Vec3&, const Vec3& normal) {
    EXPECT_EQ(normal, face);  // to the last bit, so that the face has one tone
  });
}

Extrusion column(int corners) {
  std::vector<Vec2> outline;
  for (int i = 0; i < corners; ++i) outline.push_back(turn(i, corners));
  return {{{outline}}, 3};
}

TEST(SmoothShading, RoundsAnExtrusionOfManyCorners) {
  const PreparedShape round = smooth(column(24));
  EXPECT_EQ(creases(round), 48);  // the rims
  each_corner(round.polyhedron, [](const Vec3& face, const Vec3& at, const Vec3& normal) {
    const Vec3 wanted = face.z != 0 ? face : Vec3(at.x, at.y, 0);
    EXPECT_LT(max_norm(normal - wanted), 1e-14);
  });
  EXPECT_EQ(creases(smooth(column(11))), 33);  // 360 / 11 is more than 30 degrees
}

/// A house seen from above: an L that lies almost flat, over it a shallow roof, so that its corners
/// have different normals. The outline is concave.
Mesh concave_face() {
  Mesh mesh;
  Polyhedron& p = mesh.polyhedron;
  p.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0},      {1, 1, 0},
                {1, 4, 0}, {0, 4, 0}, {4, -1, -0.25}, {0, -1, -0.25}};
  p.add_face({0, 1, 2, 3, 4, 5});
  p.add_face({7, 6, 1, 0});  // leans 14 degrees
  return mesh;
}

TEST(SmoothShading, CutsConcaveFacesIntoTriangles) {
  const Mesh mesh = concave_face();
  const PreparedShape flat = prepare_shape(mesh, 1, false);
  const PreparedShape cut = smooth(mesh);
  ASSERT_TRUE(is_shadeable(cut.polyhedron));
  EXPECT_EQ(flat.polyhedron.face_count(), 2u);
  EXPECT_EQ(cut.polyhedron.face_count(), 5u);  // four triangles, and the lean quadrilateral
  EXPECT_NEAR(area(cut.polyhedron), area(flat.polyhedron), 1e-14);
  ASSERT_EQ(cut.polyhedron.plane_groups.size(), 5u);
  for (Index f = 1; f < 4; ++f)
    EXPECT_EQ(cut.polyhedron.plane_groups[f], cut.polyhedron.plane_groups[0]);
  EXPECT_NE(cut.polyhedron.plane_groups[4], cut.polyhedron.plane_groups[0]);
  // The border stays; the fold and the three cuts are no creases.
  EXPECT_EQ(creases(cut), 8);
  EXPECT_EQ(cut.edges.size(), 12u);
  EXPECT_EQ(std::count_if(cut.edges.begin(), cut.edges.end(),
                          [](const EdgePair& e) { return e.right == kNoFace; }),
            8);
}

TEST(SmoothShading, CutsFacesWithHoles) {
  Mesh mesh;
  Polyhedron& p = mesh.polyhedron;
  p.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},
                {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}};
  p.add_loop(std::vector<Index>{0, 1, 2, 3});
  p.add_loop(std::vector<Index>{4, 5, 6, 7});
  p.end_face();
  for (const Index i : p.indices) p.corner_normals.push_back(unit(p.vertices[i] - Vec3(2, 2, -9)));
  const PreparedShape cut = smooth(mesh);
  EXPECT_EQ(cut.polyhedron.face_count(), 8u);
  EXPECT_DOUBLE_EQ(area(cut.polyhedron), 12);
  EXPECT_EQ(std::count_if(cut.edges.begin(), cut.edges.end(),
                          [](const EdgePair& e) { return e.right == kNoFace; }),
            8);
  each_corner(cut.polyhedron, [](const Vec3& face, const Vec3& at, const Vec3& normal) {
    EXPECT_EQ(face, Vec3(0, 0, 1));
    EXPECT_EQ(normal, unit(at - Vec3(2, 2, -9)));
  });
}

TEST(SmoothShading, LeavesConvexFacesWhole) {
  const PreparedShape sphere = smooth(Ellipsoid{Vec3(2), 8, 6});
  EXPECT_EQ(sphere.polyhedron.face_count(), 48u);
  Mesh mesh;
  mesh.polyhedron = sphere.polyhedron;
  mesh.polyhedron.corner_normals.clear();
  EXPECT_EQ(smooth(mesh).polyhedron.face_count(), 48u);
}

/// A tetrahedron squeezed flat, with a face that crosses itself: one part of that face looks out
/// and the other in. Its cut was once closed where it has no inside.
TEST(PreparedShape, IsNotClosedWhereAFaceCrossesItself) {
  Mesh flat;
  flat.polyhedron.vertices = {{-2, -1, 0}, {0, -1, 0}, {-1, -2, 0}, {-2, -2, 0}};
  for (const auto& face : {std::vector<Index>{0, 2, 3, 1}, {0, 1, 3}, {0, 3, 2}})
    flat.polyhedron.add_face(std::span<const Index>(face));
  const PreparedShape shape = prepare_shape(flat, 1, false);
  for (const EdgePair& e : shape.edges) EXPECT_NE(e.right, kNoFace);
  EXPECT_FALSE(shape.closed);
  EXPECT_TRUE(prepare_shape(Box{}, 1, false).closed);
}

}  // namespace
}  // namespace overstrike
