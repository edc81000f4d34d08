// The laws of every solid's faces, and closed forms of each shape.
#include "core/geometry/tessellate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/geometry/polygon.h"
#include "core/geometry/polyhedron_laws.h"
#include "core/geometry/trig.h"

namespace overstrike {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Solid {
  const char* name;
  Shape shape;
  int euler;      ///< characteristic of its surface
  double volume;  ///< of the true shape
};

Region square_with_hole() {
  // Both clockwise: to be put in order.
  return {{{{0, 0}, {0, 4}, {4, 4}, {4, 0}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}}};
}

std::vector<Solid> solids() {
  const std::vector<Vec2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const std::vector<Vec2> ring_profile{{2, 0}, {3, 0}, {3, 1}, {2, 1}};
  const std::vector<Vec2> vase{{0, 0}, {2, 0}, {1, 1}, {2, 3}, {1.5, 3}, {0.5, 1}, {0, 1}};
  const std::vector<Vec2> channel{{4.5, -0.5}, {5.5, -0.5}, {5.5, 0.5}, {4.5, 0.5}};
  const double vase_volume =
      kPi / 3 * ((4 + 2 + 1) * 1 + (1 + 2 + 4) * 2) - kPi / 3 * (2.25 + 0.75 + 0.25) * 2;
  return {
      {"box", Box{{2, 3, 4}}, 2, 24},
      {"cube", Box{}, 2, 1},
      {"cylinder", Frustum{2, 2, 5, 0}, 2, kPi * 20},
      {"prism", Frustum{2, 2, 5, 6}, 2, 6 * std::sqrt(3.0) * 5},
      {"cone", Frustum{2, 0, 3, 0}, 2, kPi * 4},
      {"cone on its tip", Frustum{0, 2, 3, 0}, 2, kPi * 4},
      {"pyramid", Frustum{std::sqrt(2.0), 0, 3, 4}, 2, 4},
      {"frustum", Frustum{3, 1, 2, 0}, 2, kPi * 2 / 3 * (9 + 3 + 1)},
      {"triangular frustum", Frustum{1, 3, 2, 3}, 2, std::sqrt(27.0) / 4 * 2 / 3 * 13},
      {"wedge", Wedge{{2, 3, 4}, 1, 0.25}, 2, 3 * 4 * 1.5},
      {"roof", Wedge{{2, 3, 4}, 0, -1}, 2, 3 * 4 * 1.0},
      {"tetrahedron", Tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}}, 2, 1},
      {"turned tetrahedron", Tetrahedron{{{0, 0, 0}, {0, 2, 0}, {1, 0, 0}, {0, 0, 3}}}, 2, 1},
      {"sphere", Ellipsoid{{2, 2, 2}}, 2, kPi * 32 / 3},
      {"ellipsoid", Ellipsoid{{1, 2, 5}}, 2, kPi * 40 / 3},
      {"torus", Torus{3, 1}, 0, 2 * kPi * kPi * 3},
      {"extrusion", Extrusion{square_with_hole(), 2}, 0, 24},
      {"two pieces",
       Extrusion{{{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{5, 0}, {7, 0}, {7, 2}, {5, 2}}}}, 3}, 4, 15},
      {"revolution", Revolution{ring_profile, 360, 0}, 0, kPi * 5},
      {"clockwise revolution", Revolution{{{2, 1}, {3, 1}, {3, 0}, {2, 0}}, 360, 0}, 0, kPi * 5},
      {"half a ring", Revolution{ring_profile, 180, 0}, 2, kPi * 2.5},
      {"most of a ring", Revolution{ring_profile, 300, 0}, 2, kPi * 5 * 300 / 360},
      {"sixth of a cake", Revolution{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, 60, 0}, 2, kPi * 4 / 6},
      {"vase", Revolution{vase, 360, 0}, 2, vase_volume},
      {"part of a vase", Revolution{vase, 100, 0}, 2, vase_volume * 100 / 360},
      {"ring with a channel", Revolution{{{4, -1}, {6, -1}, {6, 1}, {4, 1}}, 360, 0, {channel}}, 0,
       2 * kPi * 5 * 3},
      {"part of a ring with a channel",
       Revolution{{{4, -1}, {6, -1}, {6, 1}, {4, 1}}, 90, 0, {channel}}, 0, kPi / 2 * 5 * 3},
      {"two rings",
       Revolution{{{4, -1}, {6, -1}, {6, 1}, {4, 1}}, 180, 0, {{{1, 0}, {2, 0}, {2, 1}}}}, 4,
       kPi * (5 * 4 + 0.5 * 5 / 3)},
      {"beam", Sweep{square, {{0, 0, 0}, {0, 0, 5}}, false}, 2, 20},
      // A mitred corner adds as much outside as it takes inside.
      {"elbow", Sweep{square, {{0, 0, 0}, {8, 0, 0}, {8, 9, 0}}, false}, 2, 4 * 17},
      {"stair", Sweep{square, {{0, 0, 0}, {8, 0, 0}, {8, 9, 0}, {8, 9, 7}}, false}, 2, 4 * 24},
      {"frame", Sweep{square, {{0, 0, 0}, {8, 0, 0}, {8, 9, 0}, {0, 9, 0}}, true}, 0, 4 * 34},
  };
}

constexpr double kChord = 0.01;

TEST(Tessellate, SolidsAreClosed) {
  for (const Solid& s : solids()) {
    const Polyhedron p = tessellate(s.shape, kChord, false);
    EXPECT_EQ(unpaired_edges(p), 0) << s.name;
    EXPECT_EQ(equal_vertices(p), 0) << s.name;
    EXPECT_EQ(euler_characteristic(p), s.euler) << s.name;
  }
}

/// Facets may stray by the chord from the surface, so the volume by the chord times the area.
TEST(Tessellate, VolumesAreTrueWithinTheChord) {
  for (const Solid& s : solids()) {
    const Polyhedron p = tessellate(s.shape, kChord, false);
    double area = 0;
    for (Index f = 0; f < p.face_count(); ++f) area += glm::length(face_area(p, f));
    const double allowance = is_curved(s.shape) ? kChord * area : 1e-13 * s.volume;
    EXPECT_NEAR(volume(p), s.volume, allowance) << s.name;
  }
}

TEST(Tessellate, FacesArePlane) {
  for (const Solid& s : solids()) {
    EXPECT_LT(worst_unevenness(tessellate(s.shape, kChord, false)), 8) << s.name;
    EXPECT_LT(worst_group_unevenness(tessellate(s.shape, kChord, false)), 16) << s.name;
  }
}

TEST(Tessellate, SameShapeSameBytes) {
  for (const Solid& s : solids())
    EXPECT_TRUE(identical(tessellate(s.shape, kChord, true), tessellate(s.shape, kChord, true)))
        << s.name;
}

TEST(Tessellate, ValidSolidsHaveNoFault) {
  for (const Solid& s : solids()) EXPECT_EQ(validate(s.shape), "") << s.name;
}

/// Loops that meet in corners keep vertices of their own there, so that every edge has two faces.
TEST(Tessellate, RegionsMayMeetInCorners) {
  const Loop2 low{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, high{{1, 1}, {2, 1}, {2, 2}, {1, 2}};
  const Loop2 hole{{0, 0}, {0.25, 0.5}, {0.5, 0.25}};
  // An island whose corners all lie on the sides of the hole that it lies in.
  const Loop2 around{{-1, -1}, {3, -1}, {3, 3}, {-1, 3}};
  const Loop2 well{{0, 0}, {0, 1}, {0, 2}, {1, 2}, {2, 2}, {2, 1}, {2, 0}, {1, 0}};
  const Loop2 island{{0, 1}, {1, 0}, {2, 1}, {1, 2}};
  const std::pair<Region, double> regions[] = {
      {{{low, high}}, 2}, {{{low, hole}}, 1 - 0.09375}, {{{around, well, island}}, 16 - 4 + 2}};
  for (const auto& [region, area] : regions) {
    const Extrusion extrusion{region, 1};
    EXPECT_EQ(validate(extrusion), "");
    const Polyhedron p = tessellate(extrusion, kChord, false);
    EXPECT_EQ(unpaired_edges(p), 0);
    EXPECT_NEAR(volume(p), area, 1e-13);
  }
  EXPECT_NE(validate(Extrusion{{{low, {{0.5, 0}, {0.7, 0.2}, {0.3, 0.2}}}}, 1}), "");
}

/// NN74's figure a: a box, an 18 x 5 sphere and a 20-sided cylinder, 122 vertices and 118 faces.
TEST(Tessellate, CountsOfFigureA) {
  const Polyhedron box = tessellate(Box{}, 1, false);
  const Polyhedron sphere = tessellate(Ellipsoid{Vec3{1}, 18, 5}, 1, false);
  const Polyhedron cylinder = tessellate(Frustum{1, 1, 1, 20}, 1, false);
  EXPECT_EQ(box.vertices.size() + sphere.vertices.size() + cylinder.vertices.size(), 122u);
  EXPECT_EQ(box.face_count() + sphere.face_count() + cylinder.face_count(), 118u);
  EXPECT_EQ(sphere.face_count(), 90u);
  EXPECT_EQ(cylinder.face_count(), 22u);
  EXPECT_EQ(unpaired_edges(sphere), 0);
}

TEST(Tessellate, GivenSidesAreKept) {
  for (int n = 3; n < 40; ++n) {
    const std::size_t sides = static_cast<std::size_t>(n);
    EXPECT_EQ(tessellate(Frustum{1, 2, 1, n}, 1, false).face_count(), sides + 2);
    EXPECT_EQ(tessellate(Frustum{1, 0, 1, n}, 1, false).vertices.size(), sides + 1);
    EXPECT_EQ(tessellate(Ellipsoid{Vec3{1}, n, 0}, 1, false).face_count(),
              sides * std::max<std::size_t>(2, (sides + 1) / 2));
    EXPECT_EQ(tessellate(Ellipsoid{Vec3{1}, 0, n}, 1, false).face_count(), 2 * sides * sides);
    const Revolution square{{{1, 0}, {2, 0}, {2, 1}, {1, 1}}, 360, n};
    EXPECT_EQ(tessellate(square, 1, false).face_count(), 2 * sides + 2);
    Revolution part = square;
    part.angle_deg = 90;
    EXPECT_EQ(tessellate(part, 1, false).face_count(), 2 * sides + 4);
  }
}

TEST(Tessellate, FewestSidesThatKeepTheChord) {
  for (double chord : {1.0, 0.3, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const std::size_t n = tessellate(Frustum{1, 1, 1, 0}, chord, false).face_count() - 2;
    const auto strays = [](std::size_t sides) { return 1 - std::cos(kPi / double(sides)); };
    EXPECT_LE(strays(n), chord * (1 + 1e-9));
    if (n > 3) {
      EXPECT_GT(strays(n - 1), chord * (1 - 1e-9));
    }
  }
  EXPECT_EQ(tessellate(Frustum{1, 1, 1, 0}, 10, false).face_count(), 5u);
  EXPECT_EQ(tessellate(Frustum{1, 1, 1, 0}, 0, false).face_count(), 4098u);
}

TEST(Tessellate, ADrawableChordBoundsTheFacets) {
  const std::vector<Vec2> profile{{0, 0}, {1, 0}, {0.5, 2}};
  for (const Shape& shape : {Shape{Ellipsoid{{1, 2, 3}}}, Shape{Torus{}}, Shape{Frustum{}},
                             Shape{Revolution{profile, 360, 0}}}) {
    EXPECT_EQ(drawable_chord(shape, 0.01), 0.01);
    const double finest = drawable_chord(shape, 1e-300);
    EXPECT_EQ(drawable_chord(shape, 1e-12), finest);
    EXPECT_EQ(drawable_chord(shape, finest), finest);
    EXPECT_LT(finest, 1e-4);
    const std::size_t faces = tessellate(shape, finest, false).face_count();
    EXPECT_LE(faces, 0x1p20);
    EXPECT_GE(faces, 3500u);
  }
  EXPECT_EQ(drawable_chord(Box{}, 1e-300), 1e-300);
  EXPECT_EQ(drawable_chord(Revolution{profile, 1e-3, 0}, 1e-6), 1e-6);
}

TEST(Tessellate, MeshPassesThrough) {
  Mesh mesh;
  mesh.polyhedron = tessellate(Box{}, 1, false);
  EXPECT_TRUE(identical(tessellate(mesh, 1, true), mesh.polyhedron));
}

TEST(Tessellate, FlatPolygonKeepsItsSideAndTurnsItsHoles) {
  const std::vector<Vec3> outline{{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}};
  const std::vector<Vec3> hole{{1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {1, 2, 1}};
  const Polyhedron p = tessellate(FlatPolygon{{outline, hole}}, 1, false);
  ASSERT_EQ(p.face_count(), 1u);
  EXPECT_EQ(p.loop_ends.size(), 2u);
  EXPECT_EQ(face_area(p, 0), Vec3(0, 0, 15));
}

TEST(Tessellate, NamesAndCurvedness) {
  EXPECT_EQ(shape_name(Box{}), "box");
  EXPECT_EQ(shape_name(Frustum{1, 1, 1, 0}), "cylinder");
  EXPECT_EQ(shape_name(Frustum{1, 1, 1, 5}), "prism");
  EXPECT_EQ(shape_name(Frustum{1, 0, 1, 0}), "cone");
  EXPECT_EQ(shape_name(Frustum{0, 1, 1, 4}), "pyramid");
  EXPECT_EQ(shape_name(Frustum{2, 1, 1, 4}), "frustum");
  EXPECT_EQ(shape_name(Ellipsoid{}), "sphere");
  EXPECT_EQ(shape_name(Ellipsoid{{1, 1, 2}}), "ellipsoid");
  EXPECT_TRUE(is_curved(Torus{}));
  EXPECT_TRUE(is_curved(Ellipsoid{}));
  EXPECT_FALSE(is_curved(Ellipsoid{Vec3{1}, 18, 5}));
  EXPECT_TRUE(is_curved(Frustum{}));
  EXPECT_FALSE(is_curved(Frustum{1, 1, 1, 20}));
  EXPECT_FALSE(is_curved(Box{}));
}

}  // namespace
}  // namespace overstrike
