// The text of every fault.
#include <gtest/gtest.h>

#include <limits>

#include "core/geometry/tessellate.h"

namespace overstrike {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Fault {
  Shape shape;
  const char* text;
};

void expect_texts(const std::vector<Fault>& faults) {
  for (const Fault& fault : faults)
    EXPECT_EQ(validate(fault.shape), fault.text) << shape_name(fault.shape);
}

TEST(Validate, FlatFacedShapes) {
  const Vec3 o{0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  expect_texts({
      {Box{{1, 2, 3}}, ""},
      {Box{{0, 1, 1}}, "size x must be positive, found 0"},
      {Box{{1, -2.5, 1}}, "size y must be positive, found -2.5"},
      {Box{{1, 1, kNan}}, "size z must be a finite number, found nan"},
      {Box{{1e101, 1, 1}}, "size x must be at most 1e+100, found 1e+101"},
      {Box{{1e-101, 1, 1}}, "size x must be at least 1e-100, found 1e-101"},
      {Wedge{{1, 1, -1}, 0, 0}, "size z must be positive, found -1"},
      {Wedge{{1, 1, 1}, -0.5, 0}, "top must not be negative, found -0.5"},
      {Wedge{{1, 1, 1}, 0, kInfinity}, "top_shift must be a finite number, found inf"},
      {Tetrahedron{{o, x, y, {kNan, 0, 0}}}, "vertex 4 must be a finite number, found nan"},
      {Tetrahedron{{o, x, y, x + y}}, "the four vertices must not lie in one plane"},
      {Tetrahedron{{o, o, y, z}}, "the four vertices must not lie in one plane"},
      {FlatPolygon{}, "a polygon needs at least one loop"},
      {FlatPolygon{{{o, x, y}}}, ""},
      {FlatPolygon{{{o, x}}}, "loop 1 needs at least 3 points, found 2"},
      {FlatPolygon{{{o, x, {0, kInfinity, 0}}}},
       "loop 1 point 3 must be a finite number, found inf"},
      {FlatPolygon{{{o, x, 2.0 * x}}}, "loop 1 has no area"},
      {FlatPolygon{{{o, 4.0 * x, 4.0 * y, 4.0 * (x + y)}}}, ""},
      {FlatPolygon{{{o, x, y}, {x + y, 2.0 * x + y, x + 2.0 * y}}},
       "every loop after the first must be a hole in it and in no other"},
  });
}

TEST(Validate, RoundShapes) {
  expect_texts({
      {Frustum{}, ""},
      {Frustum{-1, -1, 1, 0}, "radius must be positive, found -1"},
      {Frustum{-1, 0, 1, 0}, "radius must be positive, found -1"},
      {Frustum{0, 0, 1, 0}, "radius must be positive, found 0"},
      {Frustum{1, -2, 1, 0}, "top radius must not be negative, found -2"},
      {Frustum{-1, 2, 1, 0}, "bottom radius must not be negative, found -1"},
      {Frustum{kNan, 1, 1, 0}, "bottom radius must be a finite number, found nan"},
      {Frustum{1, 1, 0, 0}, "height must be positive, found 0"},
      {Frustum{1, 1, 1, 2}, "sides must be 3 to 4096, or 0 for round, found 2"},
      {Frustum{1, 1, 1, -3}, "sides must be 3 to 4096, or 0 for round, found -3"},
      {Frustum{1, 1, 1, 5000}, "sides must be 3 to 4096, or 0 for round, found 5000"},
      {Ellipsoid{{-1, -1, -1}}, "radius must be positive, found -1"},
      {Ellipsoid{{1, 2, -3}}, "radius in z must be positive, found -3"},
      {Ellipsoid{{kInfinity, kInfinity, kInfinity}}, "radius must be a finite number, found inf"},
      {Ellipsoid{Vec3{1}, 2, 5}, "sides must be 3 to 4096, or 0 for round, found 2"},
      {Ellipsoid{Vec3{1}, 18, 1}, "rings must be 2 to 2048, or 0 for round, found 1"},
      {Torus{0, 1}, "major radius must be positive, found 0"},
      {Torus{2, -1}, "minor radius must be positive, found -1"},
      {Torus{1, 1}, ""},
      {Torus{1, 2}, "minor radius must be at most the major radius 1, found 2"},
  });
}

TEST(Validate, SweptShapes) {
  const std::vector<Vec2> square{{1, 0}, {2, 0}, {2, 1}, {1, 1}};
  const std::vector<Vec2> bow{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  expect_texts({
      {Extrusion{}, "an extrusion needs at least one loop"},
      {Extrusion{{{square}}, -1}, "height must be positive, found -1"},
      {Extrusion{{{{{0, 0}, {1, 1}, {1, 1}}}}, 1},
       "loop 1 needs at least 3 different points, found 2"},
      {Extrusion{{{square, bow}}, 1}, "loop 2 crosses or touches itself near (1, 1)"},
      {Extrusion{{{square, {{1, 0.5}, {1.5, 0.2}, {1.5, 0.8}}}}, 1},
       "loop 1 and loop 2 cross or touch near (1, 0.5)"},
      {Extrusion{{{{{0, 0}, {1, 0}, {0, kNan}}}}, 1},
       "loop 1 point 3 must be a finite number, found nan"},
      {Revolution{{{1, 0}, {2, 0}}, 360, 0}, "profile needs at least 3 different points, found 2"},
      {Revolution{{{1, 0}, {2, 0}, {-1, 1}}, 360, 0},
       "profile point 3 radius must not be negative, found -1"},
      {Revolution{bow, 360, 0}, "profile crosses or touches itself near (1, 1)"},
      {Revolution{square, 0, 0}, "angle must be above 0 and at most 360 degrees, found 0"},
      {Revolution{square, 361, 0}, "angle must be above 0 and at most 360 degrees, found 361"},
      {Revolution{square, kNan, 0}, "angle must be above 0 and at most 360 degrees, found nan"},
      {Revolution{square, 360, 2}, "sides must be 3 to 4096, or 0 for round, found 2"},
      {Revolution{square, 180, 1}, "sides must be 2 to 4096, or 0 for round, found 1"},
      {Revolution{square, 179, 1}, ""},
  });
}

TEST(Validate, Sweeps) {
  const std::vector<Vec2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const Vec3 o{0}, x{9, 0, 0}, y{9, 9, 0};
  expect_texts({
      {Sweep{{{0, 0}, {1, 0}}, {o, x}}, "profile needs at least 3 different points, found 2"},
      {Sweep{square, {o}}, "path needs at least 2 points, found 1"},
      {Sweep{square, {o, x}, true}, "a closed path needs at least 3 points, found 2"},
      {Sweep{square, {o, x, x}}, "path point 3 repeats the one before"},
      {Sweep{square, {o, x, y, o}, true},
       "the last point of a closed path must not repeat the first"},
      {Sweep{square, {o, {kNan, 0, 0}}}, "path point 2 must be a finite number, found nan"},
      {Sweep{square, {o, x, o}}, "the path turns back on itself at path point 2"},
      {Sweep{square, {o, x, {9, 0.5, 0}, {0, 0.5, 0}}},
       "the path is too short between points 2 and 3 for the profile to turn its corners"},
  });
}

TEST(Validate, Meshes) {
  const Mesh box{tessellate(Box{}, 1, false), "", {}, 0};
  Mesh far = box, short_face = box, not_a_number = box, ragged = box, hollow = box;
  far.polyhedron.indices[5] = 8;
  far.lines = {10, 11, 12, 13, 14, 15};
  short_face.polyhedron.add_face({0, 1});
  not_a_number.polyhedron.vertices[2].y = kNan;
  ragged.polyhedron.loop_ends.back() = 99;
  hollow.polyhedron.end_face();
  expect_texts({
      {box, ""},
      {Mesh{}, "the mesh has no faces"},
      {far, "face 2 (line 11) names vertex 8, but there are only 8 (from 0)"},
      {short_face, "face 7 needs at least 3 vertices, found 2"},
      {not_a_number, "vertex 2 (from 0) must be a finite number, found nan"},
      {ragged, "the mesh's lists of faces, loops and corners do not fit together"},
      {hollow, "face 7 has no vertices"},
  });
}

}  // namespace
}  // namespace overstrike
